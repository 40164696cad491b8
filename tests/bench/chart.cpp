#include "chart.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "label_layout.hpp"
#include "process.hpp"
#include "render/image.hpp"
#include "table_text.hpp"
#include "text_file.hpp"
#include "trade_off.hpp"

namespace nacre::bench {
namespace {

namespace fs = std::filesystem;

// The picture and, within a panel, the frame of the axes, in pixels.
constexpr double panelWidth = 800.0, height = 720.0;
constexpr Box frame{75.0, 65.0, 780.0, 660.0};
// Of the font below, measured.
constexpr double characterWidth = 7.4, lineHeight = 16.0;

// A logarithmic axis between two values, over pixels.
struct Axis {
    double least, most, first, last;
    double at(double value) const { return first + (last - first) * std::log(value / least) / std::log(most / least); }
};

struct Mark {
    double cost, error;
    std::string label;
    const char* colour;
    bool isFront, isSmall;
};

std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

// In single quotes of gnuplot's.
std::string quoted(const std::string& text)
{
    return '\'' + replaced(text, "'", "''") + '\'';
}

std::vector<Mark> marksOf(const Report& report, const DeviceCost& device)
{
    Measured errors = meanErrors(report, 0);
    Measured earnest = errors;
    for (std::size_t i = 0; i < earnest.size(); ++i) {
        if (isNaiveForm(report.candidates[i])) earnest[i].reset();
    }
    const std::vector<bool> front = onFront(device.cost, earnest);
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (!device.cost[i] || !errors[i] || !(*errors[i] > 0.0)) continue;
        const Candidate& candidate = report.candidates[i];
        const char* const colour = !candidate.usesLibrary ? "#c04000" : candidate.film.hasSubstrate ? "#0060b0" : "#707070";
        marks.push_back({*device.cost[i], *errors[i], isNaiveForm(candidate) ? "" : candidate.name, colour, front[i], isNaiveForm(candidate)});
    }
    return marks;
}

// Room for the marks and their labels.
Axis axisOf(const std::vector<Mark>& marks, double Mark::*value, double air, double first, double last)
{
    const auto isLess = [&](const Mark& a, const Mark& b) { return a.*value < b.*value; };
    const auto [least, most] = std::minmax_element(marks.begin(), marks.end(), isLess);
    return {(*least).*value / air, (*most).*value * air, first, last};
}

// One datablock per kind of mark: gnuplot has a colour and a shape per plot, not per point.
std::string panel(const std::vector<Mark>& marks, const DeviceCost& device, int index, int panels)
{
    const Axis x = axisOf(marks, &Mark::cost, 1.5, frame.left, frame.right), y = axisOf(marks, &Mark::error, 2.0, frame.bottom, frame.top);
    const auto share = [&](double pixel) { return number((pixel + index * panelWidth) / (panels * panelWidth)); };
    std::string text = "unset label\nunset arrow\nset title " + quoted(device.title) + "\nset xlabel " + quoted("cost over a flat shader, " + device.unit) +
                       "\nset xrange [" + number(x.least) + ':' + number(x.most) + "]\nset yrange [" + number(y.least) + ':' + number(y.most) + "]\n" +
                       "set lmargin at screen " + share(frame.left) + "\nset rmargin at screen " + share(frame.right) + "\nset bmargin at screen " +
                       number(frame.bottom / height) + "\nset tmargin at screen " + number(frame.top / height) + '\n';

    // What no candidate is beaten on: stairs from the fastest to the closest.
    std::vector<Mark> front;
    std::copy_if(marks.begin(), marks.end(), std::back_inserter(front), [](const Mark& mark) { return mark.isFront; });
    std::sort(front.begin(), front.end(), [](const Mark& a, const Mark& b) { return a.cost < b.cost; });

    std::vector<LabelledPoint> points;
    for (const Mark& mark : marks) points.push_back({x.at(mark.cost), y.at(mark.error), mark.label});
    for (std::size_t i = 0; i + 1 < front.size(); ++i) {
        const double left = x.at(front[i].cost), right = x.at(front[i + 1].cost), top = y.at(front[i].error), bottom = y.at(front[i + 1].error);
        for (double at = left; at < right; at += 8.0) points.push_back({at, top, {}});
        for (double at = bottom; at < top; at += 8.0) points.push_back({right, at, {}});
    }
    const std::vector<PlacedLabel> labels = placeLabels(points, frame, characterWidth, lineHeight);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i].label.empty()) continue;
        const auto screen = [&](double atX, double atY) { return "screen " + share(atX) + ", screen " + number(atY / height); };
        text += "set label " + quoted(marks[i].label) + " at " + screen(labels[i].x, labels[i].y) + " left textcolor rgb '" + marks[i].colour + "'\n";
        if (labels[i].isFar) {
            const double width = characterWidth * static_cast<double>(marks[i].label.size());
            const double end = std::clamp(points[i].x, labels[i].x, labels[i].x + width);
            const double side = points[i].y > labels[i].y + 0.5 * lineHeight ? 0.5 : points[i].y < labels[i].y - 0.5 * lineHeight ? -0.5 : 0.0;
            text += "set arrow from " + screen(points[i].x, points[i].y) + " to " + screen(end, labels[i].y + side * lineHeight) + " nohead linecolor rgb '#b0b0b0'\n";
        }
    }

    text += "$front << EOD\n";
    for (const Mark& mark : front) text += number(mark.cost) + ' ' + number(mark.error) + '\n';
    text += "EOD\n$marks << EOD\n";
    for (const Mark& mark : marks) {
        const int colour = static_cast<int>(std::strtol(mark.colour + 1, nullptr, 16));
        text += number(mark.cost) + ' ' + number(mark.error) + ' ' + (mark.isSmall ? "0.7" : "1.4") + ' ' + (mark.isFront ? "7 " : "6 ") +
                std::to_string(colour) + '\n';
    }
    const bool hasSmall = std::any_of(marks.begin(), marks.end(), [](const Mark& mark) { return mark.isSmall; });
    return text + "EOD\nplot $front using 1:2 with steps linewidth 2 linecolor rgb '#60b060' title 'front: none is faster and closer', "
                  "$marks using 1:2:3:4:5 with points pointsize variable pointtype variable linecolor rgb variable notitle" +
           (hasSmall ? ", keyentry with points pointsize 0.7 pointtype 6 linecolor rgb '#707070' title 'small: paper-full, one stable form made naive'" : "") + '\n';
}

}  // namespace

Outcome checkPlot(const fs::path& file)
{
    if (file.extension() != ".png") return Error{"cannot write '" + file.string() + "': expected a name that ends in .png"};
    if (Outcome writable = demo::checkWritable(file); !writable) return writable;
    if (!run({"gnuplot", "--version"})) return Error{"no plot: gnuplot is not installed (Debian 12: package gnuplot-nox)"};
    return std::monostate{};
}

Outcome plot(const Report& report, const fs::path& file)
{
    std::vector<std::string> panels;
    std::vector<std::pair<std::vector<Mark>, DeviceCost>> drawn;
    for (const DeviceCost& device : deviceCosts(report)) {
        const std::vector<Mark> marks = marksOf(report, device);
        if (!marks.empty() && drawn.size() < 2) drawn.emplace_back(marks, device);
    }
    if (drawn.empty()) return Error{"no plot: no candidate has both a speed and an error"};

    std::error_code error, ignored;
    const fs::path target = fs::is_symlink(file, ignored) ? fs::weakly_canonical(file, ignored) : file;
    fs::path partial = target;
    partial.replace_filename(".nacre-" + std::to_string(getpid()) + ".partial");
    fs::path script = partial;
    script += ".gnuplot";
    const int count = static_cast<int>(drawn.size());
    std::string text = "set terminal pngcairo size " + number(count * panelWidth) + ',' + number(height) + " font 'DejaVu Sans,10'\nset output " +
                       quoted(partial.string()) + "\nset multiplot\nset logscale xy\nset grid\nset key bottom left\nset format x '%g'\nset format y '%g'\n" +
                       "set ylabel 'mean CIEDE2000 to the spectrum, dielectrics 0-800 nm' offset 1,0\nset xtics (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 10)\n";
    for (int i = 0; i < count; ++i) text += panel(drawn[static_cast<std::size_t>(i)].first, drawn[static_cast<std::size_t>(i)].second, i, count);
    if (Result<std::string> written = writeText(script, text + "unset multiplot\n"); !written) return written.error();
    const Result<std::string> finished = run({"gnuplot", script.string()});
    fs::remove(script, ignored);
    if (finished && fs::exists(partial, ignored)) fs::rename(partial, target, error);
    else error = std::make_error_code(std::errc::io_error);
    if (!error) return std::monostate{};
    fs::remove(partial, ignored);
    return Error{"cannot write '" + file.string() + "': " + (finished ? error.message() : finished.error().message)};
}

}  // namespace nacre::bench
