// Measures the speed of shader candidates, on llvmpipe and by RADV's compiler, and the error of their films: see --help.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

#include "candidates.hpp"
#include "chart.hpp"
#include "film_sweep.hpp"
#include "progress_bar.hpp"
#include "report.hpp"
#include "shader_text.hpp"
#include "text_file.hpp"
#include "trade_off.hpp"

namespace {

using namespace nacre;
using namespace nacre::bench;

struct Options {
    LlvmpipePlan plan;
    std::string target = "rgba32f";
    std::vector<std::string> candidates;
    std::vector<std::string> families{"navi21", "navi10", "vega10"};
    FilmPlan films;
    std::string on = "both";
    std::string work = NACRE_BENCH_WORK_DIR;
    std::string csvFile, filmCsvFile, markdownFile, plotFile, sweepFile;
    bool isList = false;
};

// One line, also where the message is a compiler's log.
int fail(const Error& error)
{
    std::cerr << "nacre-bench: " << error.message.substr(0, error.message.find('\n')) << '\n';
    return 1;
}

std::vector<std::string> candidateNames()
{
    std::vector<std::string> names;
    for (const CandidateEntry& entry : candidateEntries()) names.emplace_back(entry.name);
    return names;
}

// Those asked for, flat and three.js, in the order of the list. One that cannot be loaded is noted.
Result<std::vector<Candidate>> load(const Options& options, std::vector<std::string>& notes)
{
    std::vector<Candidate> loaded;
    for (const CandidateEntry& entry : candidateEntries()) {
        const bool isWanted = options.candidates.empty() || entry.name == flatName || entry.name == referenceName ||
                              std::find(options.candidates.begin(), options.candidates.end(), entry.name) != options.candidates.end();
        if (!isWanted) continue;
        Result<Candidate> candidate = entry.load(std::filesystem::path(options.work) / "peers");
        if (!candidate) {
            if (loaded.empty()) return candidate.error();
            notes.push_back(std::string(entry.name) + " is left out: " + candidate.error().message);
            continue;
        }
        candidate->name = entry.name;
        loaded.push_back(*candidate);
    }
    return loaded;
}

void addRadv(Report& report, const Options& options, std::vector<Failure>& failures)
{
    Result<RadvReports> measured =
        measureRadv(report.candidates, options.families, std::filesystem::path(options.work) / "spirv");
    if (!measured) {
        report.notes.push_back("RADV is left out: " + measured.error().message);
        return;
    }
    for (const RadvReport& family : measured->families) {
        if (!family.failure.empty()) report.notes.push_back("RADV " + family.family + " cannot be had: " + family.failure);
    }
    report.radv = measured->families;
    failures.insert(failures.end(), measured->failures.begin(), measured->failures.end());
}

void addLlvmpipe(Report& report, const Options& options, std::vector<Failure>& failures)
{
    ProgressBar bar("llvmpipe");
    Result<LlvmpipeReport> measured =
        measureLlvmpipe(report.candidates, report.reference, options.plan, [&](double share) { bar.show(share); });
    if (!measured) {
        report.notes.push_back("llvmpipe is left out: " + measured.error().message);
        return;
    }
    report.llvmpipe = *measured;
    failures.insert(failures.end(), measured->failures.begin(), measured->failures.end());
}

void addFilms(Report& report, const Options& options, std::vector<Failure>& failures)
{
    ProgressBar bar("films");
    Result<FilmReport> measured = measureFilms(report.candidates, options.films, [&](double share) { bar.show(share); });
    if (!measured) {
        report.notes.push_back("errors are left out: " + measured.error().message);
        return;
    }
    if (std::none_of(report.candidates.begin(), report.candidates.end(), isPeer)) {
        report.notes.push_back("nacre's errors are compared with nobody's: there is no peer");
    }
    report.films = *measured;
    failures.insert(failures.end(), measured->failures.begin(), measured->failures.end());
}

// Its table goes after the others; what the picture lacks is noted.
Result<std::string> addSweep(const Options& options, Report& report)
{
    ProgressBar bar("sweep");
    Result<FilmSweep> sweep = sweepFilms(report.candidates, [&](double share) { bar.show(share); });
    if (!sweep) return sweep.error();
    if (Outcome written = demo::writeImage(sweep->picture, options.sweepFile); !written) return written.error();
    for (const std::string& name : sweep->missing) report.notes.push_back(name + " is not in " + options.sweepFile);
    return sweepTable(*sweep);
}

// A candidate whose picture is wrong has no speed anywhere.
void removeFailed(Report& report, const std::vector<Failure>& failures)
{
    const auto hasFailed = [&](const RadvShader& shader) {
        const std::string& name = report.candidates[shader.candidate].name;
        return std::any_of(failures.begin(), failures.end(), [&](const Failure& failure) { return failure.candidate == name; });
    };
    for (RadvReport& family : report.radv) {
        family.shaders.erase(std::remove_if(family.shaders.begin(), family.shaders.end(), hasFailed), family.shaders.end());
    }
}

bool isEmpty(const Report& report)
{
    const auto hasNone = [](const RadvReport& family) { return family.shaders.empty(); };
    return !report.llvmpipe && !report.films && std::all_of(report.radv.begin(), report.radv.end(), hasNone);
}

}  // namespace

int main(int argc, char** argv)
{
    Options options;
    CLI::App app{
        "Measures the speed of shaders that light a pixel: on llvmpipe with one thread, in interleaved rounds, and by what Mesa's "
        "RADV says of the code that it compiles for AMD's processors, which need not be there. Times are taken over a flat shader "
        "with the same inputs and related to three.js, which with MaterialX is fetched through npm and pip on the first run. The same "
        "shaders draw random films, whose colours are compared with their spectra: CIEDE2000."};
    app.add_option("--candidates", options.candidates, "only these, besides flat and three.js")
        ->delimiter(',')
        ->check(CLI::IsMember(candidateNames()));
    app.add_option("--on", options.on, "llvmpipe, radv, both or none")->check(CLI::IsMember({"llvmpipe", "radv", "both", "none"}))->capture_default_str();
    app.add_option("--lights", options.plan.lights, "numbers of lights, 1 to " + std::to_string(maxLights) + "; more than 1: a loop")
        ->delimiter(',')
        ->check(CLI::Range(1, maxLights))
        ->capture_default_str();
    app.add_option("--megapixels", options.plan.megapixels, "sizes of the picture, 0.01 to 16")
        ->delimiter(',')
        ->check(CLI::Range(0.01, 16.0))
        ->capture_default_str();
    app.add_option("--rounds", options.plan.rounds, "rounds over all candidates")->check(CLI::Range(1, 10000))->capture_default_str();
    app.add_option("--target", options.target, "rgba32f or rgba16f")->check(CLI::IsMember({"rgba32f", "rgba16f"}))->capture_default_str();
    app.add_option("--families", options.families, "RADV's names of processors: navi21 is RDNA2, navi10 RDNA1, vega10 GCN5, polaris10 GCN4")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--films", options.films.films, "random films of each set for the errors; 0: no errors")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    app.add_option("--seed", options.films.seed, "of the random films")->capture_default_str();
    app.add_option("--work", options.work, "folder for the peers' packages and intermediate files");
    app.add_option("--csv", options.csvFile, "also write the numbers to this file");
    app.add_option("--film-csv", options.filmCsvFile, "also write every error, by bands of thickness too, to this file");
    app.add_option("--plot", options.plotFile, "also draw speed against error to this PNG; needs gnuplot");
    app.add_option("--sweep", options.sweepFile, "also draw films by thickness and angle, beside their spectra, to this .png or .exr");
    app.add_option("--markdown", options.markdownFile, "also write the tables to this file");
    app.add_flag("--list", options.isList, "list the candidates and exit");
    app.failure_message([](const CLI::App*, const CLI::Error& error) { return std::string("nacre-bench: ") + error.what() + '\n'; });
    CLI11_PARSE(app, argc, argv);

    if (options.isList) {
        for (const CandidateEntry& entry : candidateEntries()) std::cout << entry.name << ": " << entry.shows << '\n';
        return 0;
    }
    if (!options.plotFile.empty()) {
        if (Outcome possible = checkPlot(options.plotFile); !possible) return fail(possible.error());
        if (options.films.films == 0 || options.on == "none") return fail({"--plot needs speeds and errors: not --films 0, not --on none"});
    }
    if (!options.sweepFile.empty()) {
        if (Outcome writable = demo::checkWritable(options.sweepFile); !writable) return fail(writable.error());
    }
    options.plan.halfFloat = options.target == "rgba16f";

    Report report;
    Result<std::vector<Candidate>> candidates = load(options, report.notes);
    if (!candidates) return fail(candidates.error());
    report.candidates = *candidates;
    const auto isReference = [](const Candidate& candidate) { return candidate.name == referenceName; };
    const auto reference = std::find_if(report.candidates.begin(), report.candidates.end(), isReference);
    report.reference = static_cast<std::size_t>(reference - report.candidates.begin());

    std::vector<Failure> failures;
    if (options.on != "llvmpipe" && options.on != "none") addRadv(report, options, failures);
    if (options.on != "radv" && options.on != "none") addLlvmpipe(report, options, failures);
    if (options.films.films > 0) addFilms(report, options, failures);
    removeFailed(report, failures);

    std::string sweep;
    if (!options.sweepFile.empty()) {
        Result<std::string> drawn = addSweep(options, report);
        if (!drawn) return fail(drawn.error());
        sweep = *drawn;
    }
    const std::string tables = sweep + markdown(report);
    std::cout << tables << std::flush;
    if (!options.markdownFile.empty()) {
        if (Result<std::string> written = writeText(options.markdownFile, tables); !written) return fail(written.error());
    }
    if (!options.csvFile.empty()) {
        if (Result<std::string> written = writeText(options.csvFile, csv(report)); !written) return fail(written.error());
    }
    if (!options.filmCsvFile.empty()) {
        if (Result<std::string> written = writeText(options.filmCsvFile, filmCsv(report)); !written) return fail(written.error());
    }
    if (!options.plotFile.empty()) {
        if (Outcome drawn = plot(report, options.plotFile); !drawn) return fail(drawn.error());
    }
    for (const Failure& failure : failures) fail({failure.candidate + ": " + failure.message});
    if (isEmpty(report) && sweep.empty()) return fail({"nothing could be measured"});
    return failures.empty() ? 0 : 1;
}
