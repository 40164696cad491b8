#include "report.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "csv_table.hpp"
#include "process.hpp"
#include "vectors.hpp"

namespace nacre::test {
namespace {

std::string text(const char* format, double value)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

std::string joined(const std::vector<std::string>& cells, const char* separator)
{
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() ? "" : separator) + cell;
    return line;
}

std::string quoted(const std::string& cell)
{
    return '"' + cell + '"';  // no name of ours or of a driver has a quotation mark
}

// The names in the order of their first measurement.
std::vector<std::string> names(const std::vector<Measurement>& measurements, std::string Measurement::*member)
{
    std::vector<std::string> unique;
    for (const Measurement& one : measurements) {
        if (std::find(unique.begin(), unique.end(), one.*member) == unique.end()) unique.push_back(one.*member);
    }
    return unique;
}

std::vector<std::string> measurementColumns()
{
    return {"driver", "renderer", "region", "quantity", "cases", "at_jump", "median", "p90", "p99", "p999", "worst"};
}

std::vector<std::string> allColumns()
{
    std::vector<std::string> columns = measurementColumns();
    columns.insert(columns.end(), inputColumns().begin(), inputColumns().end());
    return columns;
}

std::string table(const std::vector<Measurement>& measurements, const std::string& quantity)
{
    std::string lines = "| region | driver | cases | at a jump | median | 99.9 % | worst |\n| --- | --- | ---: | ---: | ---: | ---: | ---: |\n";
    for (const std::string& region : names(measurements, &Measurement::region)) {
        for (const Measurement& one : measurements) {
            if (one.region != region || one.quantity != quantity) continue;
            lines += "| " + joined({region, one.driver, std::to_string(one.cases), std::to_string(one.atJump), text("%.1e", one.spread.median),
                                    text("%.1e", one.spread.p999), text("%.1e", one.spread.worst)},
                                   " | ") + " |\n";
        }
    }
    return lines;
}

const char* const plotCommands = R"(
set terminal pngcairo size 1200,700 font 'DejaVu Sans,11'
set title 'Error of ρ in float32 against double precision: from the median to the worst case, mark at 99.9 %'
set ylabel '|GLSL - double| / max(1, ρ)'
set logscale y
set format y '10^{%T}'
set yrange [1e-9:1e-1]
set grid y
set key outside bottom center horizontal
set xtics rotate by -20
set bars 0.5
)";

}  // namespace

std::string markdown(const std::vector<Measurement>& measurements)
{
    std::string lines = "Error: |GLSL - double| / max(1, ρ), the worst channel of each case.\n\n";
    lines += "ρ\n\n" + table(measurements, "rho") + "\nDiffuse coefficient\n\n" + table(measurements, "diffuse") + '\n';
    for (const Region& region : regions()) lines += std::string("- ") + region.name + ": " + region.meaning + '\n';
    std::string previous;
    for (const Measurement& one : measurements) {
        if (one.driver != previous) lines += "- " + one.driver + ": " + one.renderer + '\n';
        previous = one.driver;
    }
    lines += "\nThe worst cases of ρ, for nacre-eval:\n\n```csv\ndriver,region," + joined(inputColumns(), ",") + '\n';
    for (const Measurement& one : measurements) {
        if (one.quantity == "rho") lines += one.driver + ',' + one.region + ',' + csvLine(one.spread.worstInput) + '\n';
    }
    return lines + "```\n";
}

std::string formsMarkdown(const std::vector<Measurement>& measurements)
{
    std::string head = "| form |", rule = "| --- |";
    const std::vector<std::string> regions = names(measurements, &Measurement::region);
    for (const std::string& region : regions) {
        head += ' ' + region + " |";
        rule += " ---: |";
    }
    std::string lines = head + '\n' + rule + '\n';
    for (const std::string& form : names(measurements, &Measurement::driver)) {
        lines += "| " + form + " |";
        for (const Measurement& one : measurements) {
            if (one.driver == form && one.quantity == "rho") lines += ' ' + text("%.1e", one.spread.p999) + " |";
        }
        lines += '\n';
    }
    return lines;
}

std::string csv(const std::vector<Measurement>& measurements)
{
    std::string lines = joined(allColumns(), ",") + '\n';
    for (const Measurement& one : measurements) {
        std::vector<std::string> cells = {quoted(one.driver), quoted(one.renderer), quoted(one.region), quoted(one.quantity),
                                          std::to_string(one.cases), std::to_string(one.atJump)};
        for (double error : {one.spread.median, one.spread.p90, one.spread.p99, one.spread.p999, one.spread.worst}) {
            cells.push_back(text("%.9g", error));
        }
        cells.push_back(csvLine(one.spread.worstInput));
        lines += joined(cells, ",") + '\n';
    }
    return lines;
}

Result<std::vector<Measurement>> readMeasurements(const std::string& csv)
{
    std::istringstream stream(csv);
    Result<CsvTable> table = CsvTable::read(stream);
    if (!table) return table.error();
    if (table->columns != allColumns()) return Error{"CSV: expected the columns of nacre-accuracy"};
    std::vector<Measurement> measurements;
    for (std::size_t row = 0; row < table->rows.size(); ++row) {
        std::vector<double> numbers;
        for (std::size_t column = 4; column < table->columns.size(); ++column) {
            Result<double> value = number(*table, row, column);
            if (!value) return value.error();
            numbers.push_back(*value);
        }
        const std::vector<std::string>& cells = table->rows[row];
        Components worst{};
        for (std::size_t i = 0; i < worst.size(); ++i) worst[i] = static_cast<float>(numbers[7 + i]);
        worst[thicknessComponent] = static_cast<float>(numbers[7 + thicknessComponent] / 1000.0);
        measurements.push_back({cells[0], cells[1], cells[2], cells[3], static_cast<std::uint64_t>(numbers[0]),
                                static_cast<std::uint64_t>(numbers[1]),
                                {numbers[2], numbers[3], numbers[4], numbers[5], numbers[6], input(worst)}});
    }
    return measurements;
}

Outcome plot(const std::vector<Measurement>& measurements, const std::string& file)
{
    if (run("gnuplot --version").status != 0) return Error{"no plot: gnuplot is not installed (Debian 12: package gnuplot-nox)"};
    const std::vector<std::string> drivers = names(measurements, &Measurement::driver);
    const std::vector<std::string> regionNames = names(measurements, &Measurement::region);

    std::string commands = plotCommands;
    std::vector<std::string> tics, curves;
    for (std::size_t region = 0; region < regionNames.size(); ++region) {
        tics.push_back('\'' + regionNames[region] + "' " + std::to_string(region));
    }
    commands += "set xrange [-0.6:" + text("%g", static_cast<double>(regionNames.size()) - 0.4) + "]\n";
    commands += "set xtics (" + joined(tics, ", ") + ")\nset output '" + file + "'\n";
    for (std::size_t driver = 0; driver < drivers.size(); ++driver) {
        const double shift = 0.15 * (static_cast<double>(driver) - 0.5 * static_cast<double>(drivers.size() - 1));
        const std::string data = "$data" + std::to_string(driver);
        commands += data + " << EOD\n";
        for (const Measurement& one : measurements) {
            if (one.driver != drivers[driver] || one.quantity != "rho") continue;
            const auto region = std::find(regionNames.begin(), regionNames.end(), one.region) - regionNames.begin();
            commands += text("%g", static_cast<double>(region) + shift) + text(" %g", one.spread.p999) + text(" %g", one.spread.median) +
                        text(" %g", one.spread.worst) + '\n';
        }
        commands += "EOD\n";
        curves.push_back(data + " using 1:2:3:4 with yerrorbars linewidth 2 pointtype 7 title '" + drivers[driver] + '\'');
    }
    commands += "plot " + joined(curves, ", ") + '\n';

    const std::string script = file + ".gnuplot";
    if (!(std::ofstream(script) << commands)) return Error{script + ": cannot be written"};
    const Finished finished = run("gnuplot '" + script + '\'');
    std::remove(script.c_str());
    if (finished.status != 0) return Error{"gnuplot: " + finished.output};
    return std::monostate{};
}

}  // namespace nacre::test
