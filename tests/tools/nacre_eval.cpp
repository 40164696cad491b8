// Evaluates the model for every row of a CSV table: see --help.

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>

#include "command_line.hpp"
#include "vectors.hpp"

namespace {

using namespace nacre;
using Results = std::array<double, 18>;

Result<std::vector<Results>> onCpu(const std::vector<test::Case>& cases, test::FringeForm form)
{
    Result<FringeTable> fringeTable = FringeTable::create();
    if (!fringeTable) return fringeTable.error();
    std::vector<Results> all;
    for (const test::Case& one : cases) {
        Result<Evaluation> evaluation = test::evaluate(one, form == test::FringeForm::table ? &*fringeTable : nullptr);
        if (!evaluation) return evaluation.error();
        all.push_back(test::results(*evaluation));
    }
    return all;
}

Result<std::vector<Results>> onGpu(const std::vector<test::Case>& cases, test::FringeForm form)
{
    Result<demo::Context> context = demo::Context::create();
    if (!context) return context.error();
    Result<test::GpuEvaluator> evaluator = test::GpuEvaluator::create(*context, form);
    if (!evaluator) return evaluator.error();
    std::vector<test::GpuInput> inputs;
    for (const test::Case& one : cases) {
        Result<test::GpuInput> input = test::gpuInput(one);
        if (!input) return input.error();
        inputs.push_back(*input);
    }
    Result<std::vector<test::GpuOutput>> outputs = evaluator->run(inputs);
    if (!outputs) return outputs.error();
    std::vector<Results> all;
    for (std::size_t i = 0; i < cases.size(); ++i) all.push_back(test::results(cases[i], (*outputs)[i]));
    return all;
}

// 17 digits bring a double back exactly, 9 a float.
std::string tableText(const test::CsvTable& table, const std::vector<std::string>& inputColumns, const std::vector<Results>& results, int digits)
{
    std::string text;
    const auto separate = [&] { text += text.empty() || text.back() == '\n' ? "" : ","; };
    for (const auto* columns : {&inputColumns, &test::resultColumns()}) {
        for (const std::string& column : *columns) {
            separate();
            text += column;
        }
    }
    text += '\n';
    for (std::size_t row = 0; row < results.size(); ++row) {
        for (const std::string& column : inputColumns) {
            separate();
            text += table.rows[row][table.find(column)];
        }
        for (double value : results[row]) {
            char number[40];
            std::snprintf(number, sizeof number, ",%.*g", digits, value);
            text += value != value ? ",nan" : number;
        }
        text += '\n';
    }
    return text;
}

int fail(const Error& error)
{
    std::cerr << "nacre-eval: " << error.message << '\n';
    return 1;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{
        "Reads CSV with the columns lx..n1z, ior_r..b, thickness_nm, e0, e1, ior_outside and wavelength_nm_r..b on standard "
        "input, for quality physical substrate_n_r..b and substrate_k_r..b too; writes them with rho, R, T, phi, diffuse and mean_cos per "
        "channel on standard output. Other columns are left out. With exponents 0 in the mirror direction, rho of quality physical is the "
        "film's reflectance.",
        "nacre-eval"};
    std::string on = "cpu";
    app.add_option("--on", on, "cpu: in double precision; gpu: the GLSL, in float32 (NACRE_CONTEXT=osmesa|egl)")
        ->check(CLI::IsMember({"cpu", "gpu"}))
        ->capture_default_str();
    std::string quality = "paper";
    app.add_option("--quality", quality, "paper or physical")->check(CLI::IsMember({"paper", "physical"}))->capture_default_str();
    std::string form = "table";
    app.add_option("--form", form, "fringes of quality physical; table: from a texture; analytic: without a sampler")
        ->check(CLI::IsMember({"table", "analytic"}))
        ->capture_default_str();
    if (const std::optional<int> status = demo::parseCommandLine(app, argc, argv)) return *status;
    const Quality asked = quality == "physical" ? Quality::physical : Quality::paper;
    const test::FringeForm fringes = form == "table" ? test::FringeForm::table : test::FringeForm::analytic;

    Result<test::CsvTable> table = test::CsvTable::read(std::cin);
    if (!table) return fail(table.error());
    Result<std::vector<test::Case>> cases = test::readCases(*table, asked);
    if (!cases) return fail(cases.error());
    Result<std::vector<Results>> results = on == "cpu" ? onCpu(*cases, fringes) : onGpu(*cases, fringes);
    if (!results) return fail(results.error());
    std::cout << tableText(*table, test::inputColumns(asked), *results, on == "cpu" ? 17 : 9) << std::flush;
    return std::cout ? 0 : fail({"cannot write to standard output"});
}
