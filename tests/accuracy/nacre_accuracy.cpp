// The accuracy of the GLSL over the model's domain, on every driver at hand: see --help.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "command_line.hpp"
#include "form_errors.hpp"
#include "naive_forms.hpp"
#include "process.hpp"
#include "report.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

// A driver is chosen by the environment before the first context of a process, so each gets a process of its own.
struct Driver {
    const char* name;
    const char* environment;
    const char* renderer;  // what its own name starts with; empty: any
    bool isSlow;
};
constexpr Driver drivers[] = {
    {"llvmpipe by OSMesa", "NACRE_CONTEXT=osmesa GALLIUM_DRIVER=llvmpipe", "llvmpipe", false},
    {"softpipe by OSMesa", "NACRE_CONTEXT=osmesa GALLIUM_DRIVER=softpipe", "softpipe", true},
    {"EGL", "NACRE_CONTEXT=egl EGL_LOG_LEVEL=fatal", "", false},
};

struct Options {
    std::size_t cases = 100000, slowCases = 10000;
    std::uint64_t seed = 1;
    std::string markdown, csv, plot;
    std::string driver;  // set in the processes of the drivers
    bool forms = false, bounds = false;
};

Result<std::string> readFile(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::ostringstream content;
    if (!(content << file.rdbuf())) return Error{path.string() + ": cannot be read"};
    return content.str();
}

Outcome writeFile(const std::string& path, const std::string& content)
{
    if (!(std::ofstream(path) << content)) return Error{path + ": cannot be written"};
    return std::monostate{};
}

// In the process of one driver.
Outcome measureHere(const Options& options)
{
    Result<demo::Context> context = demo::Context::create();
    if (!context) return context.error();
    for (const Driver& driver : drivers) {
        if (driver.name != options.driver) continue;
        const std::string renderer = context->renderer();
        if (renderer.rfind(driver.renderer, 0) != 0) return Error{"the context is by " + renderer};
        Result<std::vector<Measurement>> measured =
            measureDriver(*context, options.driver, driver.isSlow ? options.slowCases : options.cases, options.seed);
        if (!measured) return measured.error();
        return writeFile(options.csv, csv(*measured));
    }
    return Error{"no driver is called " + options.driver};
}

Result<std::vector<Measurement>> measureElsewhere(const Options& options, const Driver& driver)
{
    namespace fs = std::filesystem;
    const fs::path results = fs::temp_directory_path() / ("nacre-accuracy-" + std::to_string(getpid()) + ".csv");
    const Finished finished = run(std::string(driver.environment) + " '" + fs::read_symlink("/proc/self/exe").string() + "' --driver '" +
                                  driver.name + "' --cases " + std::to_string(options.cases) + " --slow-cases " +
                                  std::to_string(options.slowCases) + " --seed " + std::to_string(options.seed) + " --csv '" +
                                  results.string() + '\'');
    if (finished.status != 0) return Error{finished.output.substr(0, finished.output.find('\n'))};
    const Result<std::string> content = readFile(results);
    fs::remove(results);
    if (!content) return content.error();
    return readMeasurements(*content);
}

// On the context at hand: what each stable form of the GLSL buys, and where.
Outcome measureNaiveForms(const Options& options)
{
    Result<demo::Context> context = demo::Context::create();
    if (!context) return context.error();
    std::vector<Measurement> all;
    const auto measure = [&](const std::string& name, const std::string& form) -> Outcome {
        Result<std::vector<Measurement>> measured = measureDriver(*context, name, options.cases, options.seed, {form, {}, false});
        if (!measured) return measured.error();
        all.insert(all.end(), measured->begin(), measured->end());
        return std::monostate{};
    };
    Outcome outcome = measure("as it is", "");
    for (const NaiveForm& form : naiveForms()) {
        if (outcome) outcome = measure(form.name + ": " + form.instead, form.name);
    }
    if (!outcome) return outcome;
    const std::string report = formsMarkdown(all);
    std::cout << report << std::flush;
    return options.markdown.empty() ? Outcome(std::monostate{}) : writeFile(options.markdown, report);
}

// On the context at hand: what lib/src/form_bounds.hpp states, and what it says now.
Outcome measureFormBounds(const Options& options)
{
    Result<demo::Context> context = demo::Context::create();
    if (!context) return context.error();
    Result<std::vector<FormError>> errors = measureForms(*context, options.cases, options.seed);
    if (!errors) return errors.error();
    std::cout << "| form | up to | worst error | stated bound |\n| --- | ---: | ---: | ---: |\n";
    for (const FormError& error : *errors) {
        std::cout << "| " << error.form << " | " << error.upTo << ' ' << error.unit << " | " << error.worst << " | " << error.stated << " |\n";
    }
    return std::monostate{};
}

Outcome measureAll(const Options& options)
{
    std::vector<Measurement> all;
    for (const Driver& driver : drivers) {
        Result<std::vector<Measurement>> measured = measureElsewhere(options, driver);
        if (measured) all.insert(all.end(), measured->begin(), measured->end());
        else std::cerr << driver.name << " is left out: " << measured.error().message << '\n';
    }
    if (all.empty()) return Error{"no driver at hand"};
    const std::vector<Measurement> floor = measureInputs(options.slowCases, options.seed);
    all.insert(all.end(), floor.begin(), floor.end());

    const std::string report = markdown(all);
    std::cout << report << std::flush;
    if (!options.markdown.empty()) {
        if (Outcome written = writeFile(options.markdown, report); !written) return written;
    }
    if (!options.csv.empty()) {
        if (Outcome written = writeFile(options.csv, csv(all)); !written) return written;
    }
    if (!options.plot.empty()) {
        return plot(all, options.plot);
    }
    return std::monostate{};
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{
        "Median, 99.9th percentile and worst error of the GLSL against the double-precision model, for each region of the domain "
        "and each driver at hand: llvmpipe and softpipe by OSMesa, and what EGL gives. 'inputs alone' is the floor: how far the "
        "double-precision result moves when every float32 input moves by half an ulp. Cases on both sides of a jump of the model "
        "are counted apart.",
        "nacre-accuracy"};
    Options options;
    app.add_option("--cases", options.cases, "Random cases per region")->check(CLI::Range(1, 100000000))->capture_default_str();
    app.add_option("--slow-cases", options.slowCases, "The same for softpipe and for the floor")
        ->check(CLI::Range(1, 100000000))->capture_default_str();
    app.add_option("--seed", options.seed, "Same seed, same cases")->capture_default_str();
    app.add_option("--markdown", options.markdown, "Write the report to this file too");
    app.add_option("--csv", options.csv, "Write all percentiles and worst cases to this file; nacre-eval reads it");
    app.add_option("--plot", options.plot, "Draw the errors against the regions to this PNG, by gnuplot");
    app.add_flag("--forms", options.forms, "Instead: each stable form of the GLSL made naive by itself, the 99.9th percentile per region");
    app.add_flag("--bounds", options.bounds, "Instead: what the cheap forms of the library's parts err at most, by the range that they depend on");
    app.add_option("--driver", options.driver, "")->group("");
    if (const std::optional<int> status = demo::parseCommandLine(app, argc, argv)) return *status;

    const Outcome outcome = options.bounds ? measureFormBounds(options) : options.forms ? measureNaiveForms(options) : options.driver.empty() ? measureAll(options) : measureHere(options);
    if (outcome) return 0;
    std::cerr << "nacre-accuracy: " << outcome.error().message << '\n';
    return 1;
}
