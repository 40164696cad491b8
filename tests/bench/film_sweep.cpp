#include "film_sweep.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "film_colour.hpp"
#include "gl_candidate.hpp"
#include "table_text.hpp"

namespace nacre::bench {
namespace {

using test::FilmCase;

constexpr int width = 220, height = 126;
constexpr double mostNm = 1000.0, mostDegrees = 87.0;
constexpr double degree = 3.14159265358979 / 180.0;
// The map of differences is logarithmic between these.
constexpr double leastDifference = 0.1, mostDifference = 30.0;

struct Swept {
    const char* name;
    FilmCase film;
};

// A candidate in the picture. `isBare`: it has a perfect mirror for every substrate, so that its brightness is
// another; its own then stands for the spectrum's, and its colours can be seen.
struct Column {
    const char* candidate;
    const char* label;
    bool isBare;
};
constexpr Column columns[] = {
    {"physical-any-table", "physical, table", false}, {"physical-any", "physical, sampler-free", false}, {"paper-parallel", "paper, own brightness", true},
    {"three.js", "three.js", false},                  {"materialx-surface", "MaterialX", false},
};

Result<std::vector<Swept>> sweptFilms()
{
    Result<std::function<std::complex<double>(double)>> copper = test::metal("cu");
    if (!copper) return copper.error();
    const auto dielectric = [](const char* name, double index, double below) {
        return Swept{name, {index, {below, below, below}, {}, 0.0, 1.0}};
    };
    return std::vector<Swept>{dielectric("1.33 on 1.5", 1.33, 1.5), dielectric("1.5 on 2.5", 1.5, 2.5),
                              {"1.5 on copper", {1.5, {(*copper)(645.0), (*copper)(525.0), (*copper)(445.0)}, *copper, 0.0, 1.0}}};
}

// A film per pixel, at its middle; the top row has the largest angle.
std::vector<FilmCase> pixelsOf(const FilmCase& film)
{
    std::vector<FilmCase> films(static_cast<std::size_t>(width) * height, film);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            FilmCase& one = films[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
            one.thicknessNm = mostNm * (x + 0.5) / width;
            one.cosTheta = std::cos(degree * mostDegrees * (height - y - 0.5) / height);
        }
    }
    return films;
}

double luminance(glm::dvec3 rgb)
{
    return dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
}

// Each line over the mean luminance that `bright` has on it.
demo::Image pictureOf(const std::vector<glm::dvec3>& colours, const std::vector<glm::dvec3>& bright)
{
    constexpr double grey = 0.35;  // what that mean becomes; fringes reach twice as far
    demo::Image image{width, height, {}};
    for (std::size_t line = 0; line < static_cast<std::size_t>(height); ++line) {
        double sum = 0.0;
        for (std::size_t x = 0; x < width; ++x) sum += luminance(bright[line * width + x]) / width;
        for (std::size_t x = 0; x < width; ++x) {
            const glm::dvec3 rgb = clamp(colours[line * width + x] * (grey / std::fmax(sum, 1e-6)), 0.0, 1.0);
            for (int k = 0; k < 3; ++k) image.pixels.push_back(static_cast<float>(rgb[k]));
        }
    }
    return image;
}

// Black to white by way of violet, red and yellow: brighter is farther. In steps, which the eye reads as contours.
// Linear; the stops are sRGB's.
glm::dvec3 heat(double difference)
{
    static const glm::dvec3 stops[] = {{0.0, 0.0, 0.02}, {0.25, 0.07, 0.45}, {0.72, 0.2, 0.33}, {0.98, 0.62, 0.1}, {1.0, 1.0, 0.85}};
    constexpr double steps = 20.0;
    const double share = std::log(std::fmax(difference, 1e-9) / leastDifference) / std::log(mostDifference / leastDifference);
    const double t = std::round(std::clamp(share, 0.0, 1.0) * steps) / steps * 4.0;
    const auto left = static_cast<std::size_t>(std::fmin(t, 3.0));
    return pow(mix(stops[left], stops[left + 1], t - static_cast<double>(left)), glm::dvec3(2.2));
}

demo::Image mapOf(const std::vector<double>& differences)
{
    demo::Image image{width, height, {}};
    for (const double difference : differences) {
        const glm::dvec3 rgb = heat(difference);
        for (int k = 0; k < 3; ++k) image.pixels.push_back(static_cast<float>(rgb[k]));
    }
    return image;
}

// The map's scale from left to right, a line at 1 and at 10.
demo::Image legend()
{
    std::vector<double> differences;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double here = leastDifference * std::pow(mostDifference / leastDifference, (x + 0.5) / width);
            differences.push_back(here);
        }
    }
    demo::Image image = mapOf(differences);
    for (const double tick : {1.0, 10.0}) {
        const auto x = static_cast<std::size_t>(width * std::log(tick / leastDifference) / std::log(mostDifference / leastDifference));
        for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
            for (std::size_t k = 0; k < 3; ++k) image.pixels[(y * width + x) * 3 + k] = tick > 5.0 ? 0.0F : 1.0F;
        }
    }
    return image;
}

}  // namespace

Result<FilmSweep> sweepFilms(const std::vector<Candidate>& candidates, const std::function<void(double)>& progress)
{
    drawInCallingThread();
    Result<demo::Context> context = demo::Context::create();
    if (!context) return context.error();
    Result<std::vector<Swept>> films = sweptFilms();
    if (!films) return films.error();

    FilmSweep sweep;
    struct Drawn {
        const Column* column;
        FilmProgram program;
    };
    std::vector<Drawn> drawn;
    for (const Column& column : columns) {
        const auto isIt = [&](const Candidate& candidate) { return candidate.name == column.candidate; };
        const auto candidate = std::find_if(candidates.begin(), candidates.end(), isIt);
        if (candidate == candidates.end()) {
            sweep.missing.emplace_back(column.candidate);
            continue;
        }
        Result<FilmProgram> program = FilmProgram::create(context->gl(), *candidate);
        if (!program) return Error{candidate->name + ": " + program.error().message};
        drawn.push_back({&column, std::move(*program)});
    }

    const test::Observer observer;
    std::vector<demo::LabelledImage> panels;
    std::size_t done = 0;
    for (const Swept& swept : *films) {
        const std::vector<FilmCase> cases = pixelsOf(swept.film);
        std::vector<glm::dvec3> truth;
        truth.reserve(cases.size());
        for (const FilmCase& film : cases) {
            truth.push_back(test::trueColour(film, observer));
            if (truth.size() % width == 0) progress(static_cast<double>(done * cases.size() + truth.size()) / static_cast<double>(films->size() * cases.size()));
        }
        std::vector<demo::LabelledImage> maps{{legend(), "CIEDE2000: 0.1 to 30, lines: 1, 10"}};
        panels.push_back({pictureOf(truth, truth), std::string(swept.name) + ": spectrum"});
        for (const Drawn& one : drawn) {
            Result<std::vector<glm::dvec3>> colours = one.program.colours(cases);
            if (!colours) return Error{std::string(one.column->candidate) + ": " + colours.error().message};
            std::vector<double> differences;
            for (std::size_t i = 0; i < cases.size(); ++i) differences.push_back(test::colourDifference((*colours)[i], truth[i]));
            const auto isFinite = [](double value) { return std::isfinite(value); };
            if (!std::all_of(differences.begin(), differences.end(), isFinite)) {
                return Error{std::string(one.column->candidate) + ": a colour of " + swept.name + " is not finite"};
            }
            const test::ErrorFigures f = test::figures(differences);
            sweep.figures.push_back({swept.name, one.column->candidate, f});
            panels.push_back({pictureOf(*colours, one.column->isBare ? *colours : truth), one.column->label});
            maps.push_back({mapOf(differences), "mean " + shortly(f.mean) + ", worst " + shortly(f.worst)});
        }
        panels.insert(panels.end(), maps.begin(), maps.end());
        ++done;
    }
    sweep.picture = demo::contactSheet(panels, static_cast<int>(drawn.size()) + 1);
    return sweep;
}

std::string sweepTable(const FilmSweep& sweep)
{
    std::string text = "## Thickness 0-1000 nm by angle 0-87 degrees\n\n" + header({"film", "candidate", "mean", "95 %", "worst"});
    for (const SweepFigures& one : sweep.figures) {
        text += row({one.film, one.candidate, shortly(one.figures.mean), shortly(one.figures.percentile95), shortly(one.figures.worst)});
    }
    return text + '\n';
}

}  // namespace nacre::bench
