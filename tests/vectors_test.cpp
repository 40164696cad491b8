// The reference vectors, 50 digits, against the double-precision evaluation and the GLSL.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "gpu.hpp"
#include "vectors.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

struct Vectors {
    CsvTable table;
    std::vector<Case> cases;
    std::vector<std::array<double, 18>> expected;
};

Vectors load(const std::string& name)
{
    std::ifstream file(NACRE_TEST_DATA "/" + name);
    Result<CsvTable> table = CsvTable::read(file);
    if (!table) throw std::runtime_error(name + ": " + table.error().message);
    Result<std::vector<Case>> cases = readCases(*table);
    if (!cases) throw std::runtime_error(name + ": " + cases.error().message);
    Vectors vectors{*table, *cases, {}};
    for (std::size_t row = 0; row < table->rows.size(); ++row) {
        std::array<double, 18> results{};
        for (std::size_t i = 0; i < results.size(); ++i) {
            Result<double> cell = number(*table, row, table->find(resultColumns()[i]));
            if (!cell) throw std::runtime_error(name + ": " + cell.error().message);
            results[i] = *cell;
        }
        vectors.expected.push_back(results);
    }
    return vectors;
}

// The largest |got - expected| / max(1, ρ), each row's divided by its own allowance.
// quantity: 0 ρ, 1 R, 2 T, 3 Φ, 4 diffuse, 5 mean cosine. NaN has to meet NaN.
template <class Allowance>
double worst(const Vectors& vectors, const std::vector<std::array<double, 18>>& got, int quantity, Allowance allowance)
{
    double worst = 0.0;
    for (std::size_t row = 0; row < got.size(); ++row) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::size_t i = static_cast<std::size_t>(quantity) * 3 + channel;
            const double expected = vectors.expected[row][i];
            if (std::isnan(expected) && std::isnan(got[row][i])) continue;
            const double scale = std::max(1.0, vectors.expected[row][channel]);
            const double error = std::fabs(got[row][i] - expected) / scale / allowance(vectors.cases[row]);
            if (!(error <= worst)) worst = error;  // a NaN is taken over and then kept
            if (std::isnan(worst)) return worst;
        }
    }
    return worst;
}

double unit(const Case&) { return 1.0; }
// Beyond 10 µm the rounding of the path grows with the thickness.
double thick(const Case& one) { return std::max(1.0, one.surface.thicknessNm / 1e4); }
// Φ itself is large in thick layers: relative there.
double phase(const Case& one) { return thick(one) * 100.0; }

std::vector<std::array<double, 18>> onCpu(const Vectors& vectors)
{
    std::vector<std::array<double, 18>> all;
    for (const Case& one : vectors.cases) all.push_back(results(*evaluate(one)));
    return all;
}

std::vector<std::array<double, 18>> onGpu(const Vectors& vectors)
{
    std::vector<GpuInput> inputs;
    for (const Case& one : vectors.cases) inputs.push_back(*gpuInput(one));
    static const Result<GpuEvaluator> evaluator = GpuEvaluator::create(context());
    if (!evaluator) throw std::runtime_error(evaluator.error().message);
    const Result<std::vector<GpuOutput>> outputs = evaluator->run(inputs);
    if (!outputs) throw std::runtime_error(outputs.error().message);
    std::vector<std::array<double, 18>> all;
    for (std::size_t i = 0; i < inputs.size(); ++i) all.push_back(results(vectors.cases[i], (*outputs)[i]));
    return all;
}

// Double precision: 1e-12 where nothing is hard; 5e-11 elsewhere, since the phase of 1 mm, 1e4 cycles, leaves
// 1e-16 × 1e4 × 2π of rounding, times the few operations before it.
TEST(VectorsCpu, Typical)
{
    const Vectors vectors = load("typical.csv");
    ASSERT_EQ(vectors.cases.size(), 800U);
    const auto got = onCpu(vectors);
    for (int quantity = 0; quantity < 6; ++quantity) EXPECT_LE(worst(vectors, got, quantity, unit), 1e-12) << quantity;
}

TEST(VectorsCpu, Hard)
{
    const Vectors vectors = load("hard.csv");
    ASSERT_EQ(vectors.cases.size(), 1600U);
    const auto got = onCpu(vectors);
    for (int quantity : {0, 1, 2, 4, 5}) EXPECT_LE(worst(vectors, got, quantity, unit), 5e-11) << quantity;
    EXPECT_LE(worst(vectors, got, 3, phase), 5e-11);
}

// float32: 24 bits are 6e-8; the phase of 600 nm, 30 radians, makes of the roundings of cosines and path up
// to 2e-6, exponents of 200 as much of a lobe. 5e-6 is the bar.
TEST(VectorsGpu, Typical)
{
    const Vectors vectors = load("typical.csv");
    const auto got = onGpu(vectors);
    for (int quantity : {0, 1, 2, 4, 5}) EXPECT_LE(worst(vectors, got, quantity, unit), 5e-6) << quantity;
    EXPECT_LE(worst(vectors, got, 3, phase), 5e-7);
    RecordProperty("worst_rho", std::to_string(worst(vectors, got, 0, unit)));
    std::printf("typical, worst ρ: %.3g\n", worst(vectors, got, 0, unit));
}

// Cosines of 1e-6 in a random frame are 6e-8 / 1e-6 uncertain, and a transmittance takes their root.
TEST(VectorsGpu, Hard)
{
    const Vectors vectors = load("hard.csv");
    const auto got = onGpu(vectors);
    for (int quantity : {0, 1, 2, 4}) EXPECT_LE(worst(vectors, got, quantity, thick), 3e-4) << quantity;
    EXPECT_LE(worst(vectors, got, 5, unit), 1e-6);
    std::printf("hard, worst ρ: %.3g\n", worst(vectors, got, 0, thick));
    for (const auto& row : got) {
        for (std::size_t i = 0; i < 15; ++i) {  // all but Eq 14, which is NaN where it is not defined
            ASSERT_TRUE(std::isfinite(row[i]) && row[i] >= 0.0) << row[i];
        }
    }
}

}  // namespace
