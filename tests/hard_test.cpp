// Hard cases by name: the GLSL against the double-precision evaluation, which reference_test.cpp judges in turn.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include <nacre/parameters.hpp>

#include "gpu.hpp"
#include "random_case.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;
using glm::dvec3;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<GpuOutput> onGpu(const std::vector<GpuInput>& inputs)
{
    static const Result<GpuEvaluator> evaluator = GpuEvaluator::create(context());
    if (!evaluator) throw std::runtime_error(evaluator.error().message);
    Result<std::vector<GpuOutput>> outputs = evaluator->run(inputs);
    if (!outputs) throw std::runtime_error(outputs.error().message);
    return *outputs;
}

std::vector<GpuOutput> onGpu(const std::vector<Case>& cases)
{
    std::vector<GpuInput> inputs;
    for (const Case& one : cases) inputs.push_back(*gpuInput(one));
    return onGpu(inputs);
}

// A direction of that cosine to z; below the horizon where the cosine is negative.
dvec3 direction(double cosine, double azimuthDegrees)
{
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0)), azimuth = glm::radians(azimuthDegrees);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

dvec3 tilted(double degrees)
{
    return {std::sin(glm::radians(degrees)), 0.0, std::cos(glm::radians(degrees))};
}

Case level(double lightCosine, double viewCosine, double viewAzimuth = 180.0)
{
    Case one;
    one.light = direction(lightCosine, 0.0);
    one.view = direction(viewCosine, viewAzimuth);
    one.material.ior = {1.4, 1.45, 1.6};
    one.surface.thicknessNm = 300.0;
    return one;
}

// With z up a cosine is a float as it stands: 5e-5 is the bar, for d <= 10 µm. In a random frame it is the
// difference of products, 6e-8 uncertain whatever its size, of which a transmittance takes the root: 3e-4.
constexpr double zUp = 5e-5;
constexpr double anyFrame = 3e-4;

void expectAccurate(std::vector<Case> cases, double bound = zUp)
{
    for (Case& one : cases) one = rounded(one);
    const std::vector<GpuOutput> got = onGpu(cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Evaluation expected = *evaluate(cases[i]);
        for (int channel = 0; channel < 3; ++channel) {
            const double rho = static_cast<double>(got[i].rho[channel]), shaded = static_cast<double>(got[i].shaded[channel]);
            ASSERT_TRUE(std::isfinite(rho) && rho >= 0.0) << "case " << i << " channel " << channel << ": " << rho;
            const double allowed = bound * std::max({1.0, expected.rho[channel], cases[i].surface.thicknessNm / 1e4});
            EXPECT_NEAR(rho, expected.rho[channel], allowed) << "case " << i << " channel " << channel;
            EXPECT_NEAR(shaded, expected.shaded[channel], 2.0 * allowed) << "case " << i << " channel " << channel;
        }
    }
}

// The same cases, everything turned by one rotation.
void expectAccurateInAnyFrame(std::vector<Case> cases)
{
    expectAccurate(cases);
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 1.1, dvec3(1.0, 2.0, 3.0)));
    for (Case& one : cases) {
        one.light = turn * one.light;
        one.view = turn * one.view;
        one.surface.upperNormal = turn * one.surface.upperNormal;
        one.surface.lowerNormal = turn * one.surface.lowerNormal;
    }
    expectAccurate(cases, anyFrame);
}

TEST(Hard, Grazing)
{
    std::vector<Case> cases;
    for (double light : {1.0, 1e-2, 1e-4, 1e-6}) {
        for (double view : {1.0, 1e-2, 1e-4, 1e-6}) {
            for (double azimuth : {180.0, 179.0, 0.0}) cases.push_back(level(light, view, azimuth));
        }
    }
    expectAccurateInAnyFrame(cases);
}

TEST(Hard, HorizonAndBelowAreExactlyZero)
{
    std::vector<Case> cases;
    for (double cosine : {0.0, -0.0, -1e-6, -1e-2, -1.0}) {
        cases.push_back(level(cosine, 0.5));
        cases.push_back(level(0.5, cosine));
        cases.push_back(level(cosine, cosine));
    }
    for (Case& one : cases) one.material.upperExponent = one.material.lowerExponent = 0.0;
    for (const GpuOutput& output : onGpu(cases)) {
        EXPECT_EQ(output.rho, glm::vec3(0.0F));
        EXPECT_EQ(output.shaded, glm::vec3(0.0F));
    }
}

TEST(Hard, LightViewAndNormalAreOne)
{
    expectAccurateInAnyFrame({level(1.0, 1.0)});
}

TEST(Hard, ExactMirrorAtEveryExponent)
{
    std::vector<Case> cases;
    for (double cosine : {1.0, 0.9, 0.5, 0.1, 0.01}) {
        for (double exponent : {0.0, 1e-3, 1.0, 1e5, 1e6}) {
            cases.push_back(level(cosine, cosine));
            cases.back().material.upperExponent = cases.back().material.lowerExponent = exponent;
        }
    }
    expectAccurateInAnyFrame(cases);
}

// On the flank of the lobe: 1 - cosine of the order of 1 / exponent, where the power is steepest.
TEST(Hard, FlankOfNarrowLobes)
{
    std::vector<Case> cases;
    for (double exponent : {1e3, 1e4, 1e5, 1e6}) {
        for (double flank : {0.1, 0.5, 1.0, 3.0}) {
            for (double cosine : {0.95, 0.5, 0.2}) {
                Case one = level(cosine, std::cos(std::acos(cosine) + std::sqrt(2.0 * flank / exponent)));
                one.material.upperExponent = one.material.lowerExponent = exponent;
                cases.push_back(one);
                one.surface.lowerNormal = tilted(5.0);
                cases.push_back(one);
            }
        }
    }
    expectAccurateInAnyFrame(cases);
}

TEST(Hard, LobeCosineOfExactlyZero)
{
    // l along x at 45 degrees, v turned a quarter about its mirror direction: 2 ci co = l·v.
    std::vector<Case> cases;
    for (double exponent : {0.0, 1e-3, 1.0, 1e5, 1e6}) {
        Case one = level(1.0, 0.0);
        one.view = {1.0, 0.0, 1e-7};  // just above the horizon; the lobe's cosine is as small
        one.material.upperExponent = exponent;
        one.material.lowerExponent = 50.0;
        cases.push_back(one);
    }
    for (Case& one : cases) one = rounded(one);
    const std::vector<GpuOutput> got = onGpu(cases);
    for (const GpuOutput& output : got) {
        for (int channel = 0; channel < 3; ++channel) EXPECT_TRUE(std::isfinite(output.rho[channel]) && output.rho[channel] >= 0.0F);
    }
    EXPECT_GT(got[0].R.g, 0.03F);  // 0^0 = 1: exponent 0 reflects everywhere
    EXPECT_EQ(got[4].R.g, 0.0F);
}

TEST(Hard, Indices)
{
    std::vector<Case> cases;
    for (const dvec3& ior : {dvec3(1.0), dvec3(1.0 + 1e-7), dvec3(1.0 - 1e-7), dvec3(4.0), dvec3(1.6, 1.45, 1.4), dvec3(1.0, 1.2, 4.4), dvec3(0.1), dvec3(10.0)}) {
        for (double cosine : {1.0, 0.7, 0.3}) {
            cases.push_back(level(cosine, cosine));
            cases.back().material.ior = ior;
            cases.push_back(level(cosine, 0.9 * cosine, 170.0));
            cases.back().material.ior = ior;
        }
    }
    expectAccurateInAnyFrame(cases);
}

TEST(Hard, TotalReflectionPerChannel)
{
    // Outside 1.5: red and green are totally reflected at 60 degrees, blue is not.
    std::vector<Case> cases;
    for (const auto& [light, view] : {std::pair{0.5, 0.5}, {0.5, 0.95}, {0.95, 0.5}}) {
        Case one = level(light, view);
        one.material.iorOutside = 1.5;
        one.material.ior = {1.0, 1.2, 1.4};
        cases.push_back(one);
    }
    expectAccurateInAnyFrame(cases);
    const std::vector<GpuOutput> got = onGpu(cases);
    EXPECT_NEAR(got[0].R.r, 1.0F, 1e-6F);  // all of it, but for the lobe's rounding
    EXPECT_EQ(got[0].T.r, 0.0F);
    EXPECT_GT(got[0].T.b, 0.0F);
    EXPECT_EQ(got[2].T.r, 0.0F);  // the viewer's side alone
    EXPECT_LT(got[2].R.r, 1.0F);
}

TEST(Hard, Thickness)
{
    std::vector<Case> cases;
    for (double thickness : {0.0, 1e-3, 1e2, 1e4, 1e5, 1e6}) {
        for (double cosine : {1.0, 0.6, 0.2}) {
            cases.push_back(level(cosine, cosine));
            cases.back().surface.thicknessNm = thickness;
        }
    }
    expectAccurateInAnyFrame(cases);
}

TEST(Hard, LowerNormalAtAnyAngle)
{
    std::vector<Case> cases;
    for (double angle : {0.0, 1e-3, 60.0, 89.9, 90.0, 120.0, 180.0}) {
        for (double exponent : {0.0, 1.0, 50.0}) {
            for (double azimuth : {180.0, 100.0, 10.0}) {
                Case one = level(0.8, 0.6, azimuth);
                one.surface.lowerNormal = tilted(angle);
                one.material.lowerExponent = exponent;
                cases.push_back(one);
            }
        }
    }
    expectAccurateInAnyFrame(cases);
}

// R = T and cos 2Φ = -1: what is left is the square of the phase's rounding, 1e-7 of a cycle: far below R.
TEST(Hard, Extinction)
{
    const double f = 0.5 * (3.0 - std::sqrt(5.0));
    const double ior = (1.0 + std::sqrt(f)) / (1.0 - std::sqrt(f));
    Case one = level(1.0, 1.0);
    one.material.ior = dvec3(ior);
    one.material.upperExponent = one.material.lowerExponent = 0.0;
    one.surface.thicknessNm = 525.0 / (4.0 * ior);
    one = rounded(one);
    const double got = static_cast<double>(onGpu({one}).front().rho.g), expected = evaluate(one)->rho.g;
    // R is 0.38; a sum of R, T and the cosine would leave 1e-8 of it, in either sign.
    EXPECT_GE(got, 0.0);
    EXPECT_NEAR(got, expected, 1e-12);
    // A quarter of a percent off the dark fringe the value is small and known to a relative 1e-4.
    one.surface.thicknessNm *= 1.0025;
    one = rounded(one);
    const double near = evaluate(one)->rho.g;
    EXPECT_LT(near, 1e-4);
    EXPECT_NEAR(static_cast<double>(onGpu({one}).front().rho.g), near, 1e-3 * near);
}

TEST(Hard, VanishingLobesKeepTheirRelativeAccuracy)
{
    // R and T near 1e-30: 30 degrees off the mirror direction at an exponent of 500.
    Case one = level(0.9, 0.9);
    one.material.upperExponent = 520.0;
    one.material.lowerExponent = 1150.0;
    one.view = direction(std::cos(std::acos(0.9) + glm::radians(29.5)), 180.0);
    one = rounded(one);
    const Evaluation expected = *evaluate(one);
    const GpuOutput got = onGpu({one}).front();
    for (int channel = 0; channel < 3; ++channel) {
        ASSERT_GT(expected.R[channel], 1e-37);
        ASSERT_LT(expected.R[channel], 1e-25);
        // The logarithm is 70: 70 roundings of 6e-8, and as much again of the exponential.
        EXPECT_NEAR(static_cast<double>(got.R[channel]), expected.R[channel], 3e-5 * expected.R[channel]);
        EXPECT_NEAR(static_cast<double>(got.T[channel]), expected.T[channel], 3e-5 * expected.T[channel]);
        EXPECT_GT(got.rho[channel], 0.0F);
    }
}

TEST(Hard, EdgesOfTheVisibleSpectrum)
{
    Case one = level(0.7, 0.65);
    one.material.wavelengthNm = {780.0, 580.0, 380.0};
    expectAccurateInAnyFrame({one});
}

TEST(Hard, NormalsAsInterpolationLeavesThem)
{
    Case one = level(0.7, 0.65);
    one.surface.lowerNormal = tilted(10.0);
    std::vector<Case> cases;
    for (double length : {0.7, 1e-3, 1e-18, 1e-30, 1e18, 1e30}) {
        cases.push_back(one);
        cases.back().surface.upperNormal *= length;
        cases.push_back(one);
        cases.back().surface.lowerNormal *= length;
    }
    expectAccurateInAnyFrame(cases);
}

TEST(Hard, NormalsWithoutDirectionAreBlack)
{
    const GpuInput good = *gpuInput(rounded(level(0.7, 0.65)));
    std::vector<GpuInput> inputs;
    for (double bad : {0.0, nan, infinity, -infinity}) {
        for (int component = 0; component < 3; ++component) {
            for (glm::vec3 GpuInput::*normal : {&GpuInput::upperNormal, &GpuInput::lowerNormal}) {
                inputs.push_back(good);
                inputs.back().*normal = glm::vec3(0.0F);
                (inputs.back().*normal)[component] = static_cast<float>(bad);
                inputs.push_back(inputs.back());
                (inputs.back().*normal)[(component + 1) % 3] = bad == 0.0 ? 0.0F : 1.0F;
            }
        }
    }
    for (const GpuOutput& output : onGpu(inputs)) {
        EXPECT_EQ(output.rho, glm::vec3(0.0F));
        EXPECT_EQ(output.shaded, glm::vec3(0.0F));
        EXPECT_EQ(output.diffuse, glm::vec3(0.0F));
    }
}

// A direction that is not a number is the host's fault; bloom must not spread it all the same.
TEST(Hard, DirectionsAndThicknessThatAreNoNumbersStayFinite)
{
    const GpuInput good = *gpuInput(rounded(level(0.7, 0.65)));
    std::vector<GpuInput> inputs;
    for (double bad : {nan, infinity, -infinity, 1e38, 1e20}) {
        for (int component = 0; component < 3; ++component) {
            for (glm::vec3 GpuInput::*vector : {&GpuInput::light, &GpuInput::view}) {
                inputs.push_back(good);
                (inputs.back().*vector)[component] = static_cast<float>(bad);
            }
        }
        inputs.push_back(good);
        inputs.back().thicknessUm = static_cast<float>(bad);
    }
    const std::vector<GpuOutput> outputs = onGpu(inputs);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_TRUE(std::isfinite(outputs[i].rho[channel]) && outputs[i].rho[channel] >= 0.0F) << i << ": " << outputs[i].rho[channel];
            EXPECT_TRUE(std::isfinite(outputs[i].shaded[channel]) && outputs[i].shaded[channel] >= 0.0F) << i << ": " << outputs[i].shaded[channel];
        }
    }
}

// A half holds up to 65504. ρ <= (√R + √T)² <= 4 and ρd <= 2, so the largest weights that validate, 1000 each, make
// 6000: no light of radiance up to 10 overflows.
TEST(Hard, HalfFloatTargetsDoNotOverflow)
{
    Case one = level(1.0, 1.0);
    one.material.ior = dvec3(3.6);
    one.material.upperExponent = one.material.lowerExponent = 0.0;
    double largest = 0.0;
    for (double thickness = 0.0; thickness < 400.0; thickness += 1.0) {
        one.surface.thicknessNm = thickness;
        for (const Parameter& parameter : parameters()) {
            if (parameter.name == "specularWeight" || parameter.name == "diffuseWeight") {
                one.material.*std::get<double Material::*>(parameter.member) = parameter.most;
            }
        }
        largest = std::max(largest, evaluate(one)->shaded.g);
    }
    EXPECT_GT(largest, 3000.0);
    EXPECT_LT(10.0 * largest, 65504.0);
}

}  // namespace
