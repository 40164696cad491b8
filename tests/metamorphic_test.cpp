// What must not change a result, and by how much it does.

#include <gtest/gtest.h>

#include "gpu.hpp"
#include "random_case.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

constexpr int count = 20000;

std::vector<GpuOutput> onGpu(const std::vector<Case>& cases)
{
    static const Result<GpuEvaluator> evaluator = GpuEvaluator::create(context());
    if (!evaluator) throw std::runtime_error(evaluator.error().message);
    std::vector<GpuInput> inputs;
    for (const Case& one : cases) inputs.push_back(*gpuInput(one));
    Result<std::vector<GpuOutput>> outputs = evaluator->run(inputs);
    if (!outputs) throw std::runtime_error(outputs.error().message);
    return *outputs;
}

std::vector<Case> typical()
{
    TypicalCases random(1);
    std::vector<Case> cases;
    for (int i = 0; i < count; ++i) cases.push_back(random.next());
    return cases;
}

double distance(const std::vector<GpuOutput>& one, const std::vector<GpuOutput>& other)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const double a = static_cast<double>(one[i].rho[channel]), b = static_cast<double>(other[i].rho[channel]);
            worst = std::max(worst, std::fabs(a - b) / std::max(1.0, a));
        }
    }
    return worst;
}

TEST(Metamorphic, OneRotationOfEverythingChangesRoundingOnly)
{
    const std::vector<Case> cases = typical();
    std::vector<Case> turned = cases;
    TypicalCases random(2);
    for (Case& one : turned) {
        const glm::dmat3 turn = random.rotation();
        one.light = turn * one.light;
        one.view = turn * one.view;
        one.surface.upperNormal = turn * one.surface.upperNormal;
        one.surface.lowerNormal = turn * one.surface.lowerNormal;
    }
    const double worst = distance(onGpu(cases), onGpu(turned));
    std::printf("rotation changes ρ by up to %.3g\n", worst);
    // Rounding the turned directions to float32 moves them by 6e-8 each, which exponents of 200 make 1e-5 of.
    EXPECT_LE(worst, 2e-5);
}

// Indices times s, thickness over s: the same phases and reflectances. By a power of two the host's arithmetic is the
// same to the last bit, so the block is but for its cycles, which double while the thickness halves.
TEST(Metamorphic, ScalingIndicesAndThicknessByTwoChangesNothing)
{
    const std::vector<Case> cases = typical();
    std::vector<Case> scaled = cases;
    for (Case& one : scaled) {
        one.material.ior *= 2.0;
        one.material.iorOutside *= 2.0;
        one.surface.thicknessNm /= 2.0;
    }
    EXPECT_EQ(distance(onGpu(cases), onGpu(scaled)), 0.0);
}

TEST(Metamorphic, ScalingByAnotherFactorChangesRoundingOnly)
{
    const std::vector<Case> cases = typical();
    std::vector<Case> scaled = cases;
    for (Case& one : scaled) {
        one.material.ior *= 1.37;
        one.material.iorOutside *= 1.37;
        one.surface.thicknessNm /= 1.37;
    }
    const double worst = distance(onGpu(cases), onGpu(scaled));
    std::printf("scaling changes ρ by up to %.3g\n", worst);
    // The thickness is rounded to float32 anew: 6e-8 of 30 radians.
    EXPECT_LE(worst, 4e-6);
}

TEST(Metamorphic, LightAndViewSwappedKeepLobesAndPath)
{
    const std::vector<Case> cases = typical();
    std::vector<Case> swapped = cases;
    for (Case& one : swapped) std::swap(one.light, one.view);
    const std::vector<GpuOutput> a = onGpu(cases), b = onGpu(swapped);
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].lobes, b[i].lobes) << i;  // bit for bit
        ASSERT_EQ(a[i].phi, b[i].phi) << i;
    }
}

// Not reciprocal, and it creates energy: the paper's own formula, measured so that nobody assumes it.
TEST(Metamorphic, ReciprocityAndEnergyOfThePapersFormulaAreKnown)
{
    double asymmetry = 0.0;
    for (const Case& one : typical()) {
        Case swapped = one;
        std::swap(swapped.light, swapped.view);
        const Evaluation a = *evaluate(one), b = *evaluate(swapped);
        for (int channel = 0; channel < 3; ++channel) {
            const double larger = std::max(a.rho[channel], b.rho[channel]);
            if (larger > 0.01) asymmetry = std::max(asymmetry, std::fabs(a.rho[channel] - b.rho[channel]) / larger);
        }
    }
    // Directional albedo of a smooth surface: ρ in the mirror direction, exponents 0.
    double albedo = 0.0;
    Case one;
    one.light = one.view = {0.0, 0.0, 1.0};
    one.material.upperExponent = one.material.lowerExponent = 0.0;
    for (double ior = 1.0; ior <= 4.0; ior += 0.05) {
        one.material.ior = glm::dvec3(ior);
        for (double thickness = 0.0; thickness <= 300.0; thickness += 5.0) {
            one.surface.thicknessNm = thickness;
            albedo = std::max(albedo, evaluate(one)->rho.g);
        }
    }
    std::printf("asymmetry up to %.2f of ρ, mirror albedo up to %.2f\n", asymmetry, albedo);
    EXPECT_GT(asymmetry, 0.1);
    EXPECT_GT(albedo, 1.5);
    EXPECT_LE(albedo, 2.0 + 1e-9);  // (√R + √T)² with R + T <= 1
}

}  // namespace
