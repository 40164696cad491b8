// Limits that need no reference: each follows from the equations by hand.

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <nacre/evaluate.hpp>

namespace {

using namespace nacre;
using glm::dvec3;

constexpr double pi = glm::pi<double>();
// A few roundings of numbers near 1; nothing here is ill-conditioned.
constexpr double rounding = 1e-14;

dvec3 direction(double degrees, double azimuthDegrees = 0.0)
{
    const double theta = glm::radians(degrees), azimuth = glm::radians(azimuthDegrees);
    return {std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta)};
}

Material film(double ior, double upperExponent, double lowerExponent)
{
    Material material;
    material.ior = dvec3(ior);
    material.upperExponent = upperExponent;
    material.lowerExponent = lowerExponent;
    return material;
}

Surface level(double thicknessNm)
{
    Surface surface;
    surface.thicknessNm = thicknessNm;
    return surface;
}

TEST(Analytic, NormalIncidenceIsTheTwoBeamFormula)
{
    const double r1 = 1.5, d = 137.0, f = 0.04;
    const Evaluation e = *evaluate(film(r1, 90.0, 170.0), level(d), {0, 0, 1}, {0, 0, 1});
    // l = v = n: both lobes are 1, R = f, T = (1 - f)².
    const double T = (1.0 - f) * (1.0 - f);
    for (int channel = 0; channel < 3; ++channel) {
        const double wavelength = Material{}.wavelengthNm[channel];
        const double phase = 2.0 * pi * r1 * d / wavelength;
        EXPECT_NEAR(e.R[channel], f, rounding);
        EXPECT_NEAR(e.T[channel], T, rounding);
        EXPECT_NEAR(e.phi[channel], phase, rounding * phase);
        EXPECT_NEAR(e.rho[channel], f + T + 2.0 * std::cos(2.0 * phase) * std::sqrt(f * T), 1e-13);
    }
}

TEST(Analytic, NoLayerIsATransparentSurfaceOverAMirror)
{
    // Matched indices: nothing is reflected above, all of the light comes back from below.
    const Evaluation e = *evaluate(film(1.0, 90.0, 0.0), level(0.0), {0, 0, 1}, {0, 0, 1});
    EXPECT_EQ(e.R, dvec3(0.0));
    EXPECT_NEAR(e.rho.g, 1.0, rounding);
    EXPECT_NEAR(e.meanCos.g, 0.5, rounding);  // Eq 14's limit
}

TEST(Analytic, ZeroThicknessHasNoColour)
{
    const Evaluation e = *evaluate(film(1.5, 90.0, 170.0), level(0.0), direction(30), direction(28, 180));
    EXPECT_NEAR(e.rho.r, e.rho.g, rounding);
    EXPECT_NEAR(e.rho.g, e.rho.b, rounding);
    EXPECT_EQ(e.phi, dvec3(0.0));
}

TEST(Analytic, MirrorDirectionHasLobesOfOne)
{
    for (double angle : {0.0, 10.0, 45.0, 80.0, 89.9}) {
        const Evaluation e = *evaluate(film(1.5, 1e6, 1e6), level(300.0), direction(angle), direction(angle, 180));
        const double c = std::cos(glm::radians(angle)), ci = std::sqrt(1.0 - (1.0 - c * c) / 2.25);
        const double F = 0.04 + 0.96 * std::pow(1.0 - c, 5);
        EXPECT_NEAR(e.R.g, F, 1e-9) << angle;  // exponent 1e6 times the rounding of the directions
        EXPECT_NEAR(e.T.g, (1.0 - F) * 0.96 * (1.0 - std::pow(1.0 - ci, 5)), 1e-9) << angle;
        EXPECT_NEAR(e.phi.g, pi * 1.5 * 300.0 / 525.0 * 2.0 * ci, 1e-12) << angle;
    }
}

TEST(Analytic, BelowTheHorizonIsBlack)
{
    for (const auto& [light, view] : {std::pair{direction(91), direction(20)}, {direction(20), direction(91)}, {dvec3(1, 0, 0), direction(20)}}) {
        Surface surface = level(300.0);
        surface.upperNormal = {0, 0, 2.0};
        const Evaluation e = *evaluate(film(1.5, 0.0, 0.0), surface, light, view);
        EXPECT_EQ(e.rho, dvec3(0.0));
        EXPECT_EQ(e.shaded, dvec3(0.0));
    }
}

TEST(Analytic, ANormalWithoutDirectionGivesZero)
{
    Surface surface = level(300.0);
    surface.lowerNormal = dvec3(0.0);
    const Evaluation e = *evaluate(film(1.5, 0.0, 0.0), surface, {0, 0, 1}, {0, 0, 1});
    EXPECT_EQ(e.rho, dvec3(0.0));
    EXPECT_EQ(e.shaded, dvec3(0.0));
}

TEST(Analytic, LengthOfANormalDoesNotMatter)
{
    const dvec3 n = glm::normalize(dvec3(0.1, -0.2, 1.0));
    Surface one = level(300.0), other = level(300.0);
    one.upperNormal = one.lowerNormal = n;
    other.upperNormal = 0.7 * n;
    other.lowerNormal = 1e-200 * n;
    const Material material = film(1.5, 90.0, 170.0);
    const Evaluation a = *evaluate(material, one, direction(20), direction(25, 180));
    const Evaluation b = *evaluate(material, other, direction(20), direction(25, 180));
    EXPECT_NEAR(a.rho.g, b.rho.g, 1e-13);  // 170 times the rounding of a direction
}

TEST(Analytic, TotalReflectionOfTheLightReflectsAllAndOfTheViewerKeepsR)
{
    // Index 1 below 1.5: the critical angle is 41.8 degrees.
    Material material = film(1.0, 0.0, 0.0);
    material.iorOutside = 1.5;
    const Evaluation light = *evaluate(material, level(300.0), direction(60), direction(20));
    EXPECT_EQ(light.R, dvec3(1.0));
    EXPECT_EQ(light.T, dvec3(0.0));
    EXPECT_EQ(light.phi, dvec3(0.0));
    const Evaluation view = *evaluate(material, level(300.0), direction(20), direction(60));
    EXPECT_GT(view.R.g, 0.0);
    EXPECT_LT(view.R.g, 1.0);
    EXPECT_EQ(view.T, dvec3(0.0));
    EXPECT_TRUE(std::isnan(view.meanCos.g));
}

TEST(Analytic, ExtinctionIsZeroNotItsRounding)
{
    // R = T and cos 2Φ = -1 at normal incidence: f = (1 - f)² has f = (3 - √5)/2; r1 = (1 + √f)/(1 - √f).
    const double f = 0.5 * (3.0 - std::sqrt(5.0));
    const double r1 = (1.0 + std::sqrt(f)) / (1.0 - std::sqrt(f));
    const Evaluation e = *evaluate(film(r1, 0.0, 0.0), level(525.0 / (4.0 * r1)), {0, 0, 1}, {0, 0, 1});
    EXPECT_LT(e.rho.g, 1e-30);
    EXPECT_GE(e.rho.g, 0.0);
}

TEST(Analytic, DiffuseEnergiesAddUp)
{
    // Eqs 12 and 13 as printed against the coefficient's range, 1 ± 2 sqrt(Td (1 - Td)).
    const double r0 = 1.0, r1 = 1.5;
    const double Rd = (-38.0 * r0 * r1 + 21.0 * (r1 * r1 + r0 * r0)) / (21.0 * (r1 + r0) * (r1 + r0));
    const double Td = 80.0 / 21.0 * r0 * r1 / ((r1 + r0) * (r1 + r0));
    EXPECT_NEAR(Rd + Td, 1.0, rounding);
    const Evaluation bright = *evaluate(film(r1, 1, 1), level(0.0), {0, 0, 1}, {0, 0, 1});
    EXPECT_NEAR(bright.diffuse.g, 1.0 + 2.0 * std::sqrt(Td * Rd), rounding);
    const Evaluation dark = *evaluate(film(r1, 1, 1), level(525.0 / (4.0 * r1)), {0, 0, 1}, {0, 0, 1});
    EXPECT_NEAR(dark.diffuse.g, 1.0 - 2.0 * std::sqrt(Td * Rd), rounding);
    EXPECT_NEAR(bright.meanCos.g, 0.8353, 5e-5);  // model.md's value for 1.5, where the paper prints .85
}

TEST(Analytic, ShadedIsTheWeightedSumTimesTheCosine)
{
    Material material = film(1.5, 90.0, 170.0);
    material.specularWeight = 1.0;
    material.diffuseWeight = 0.7;
    const Evaluation e = *evaluate(material, level(120.0), direction(40), direction(35, 180));
    EXPECT_NEAR(e.shaded.g, (e.rho.g + 0.7 * e.diffuse.g) * std::cos(glm::radians(40.0)), rounding);
}

TEST(Analytic, DeviationTurnsTheLowerNormalByItsAngle)
{
    Material material;
    material.lowerNormal = LowerNormal::constant;
    material.deviationDegrees = 10.0;
    material.azimuthDegrees = 90.0;
    const dvec3 n = glm::normalize(dvec3(1, 2, 3));
    const Surface s = *surface(material, n, {1, 0, 0, 1}, {0, 0, 0});
    EXPECT_NEAR(glm::degrees(std::acos(glm::dot(s.upperNormal, s.lowerNormal))), 10.0, 1e-12);
    // Azimuth 90: across the tangent, so the tilt has no part along it.
    const dvec3 tangent = glm::normalize(dvec3(1, 0, 0) - n * n.x);
    EXPECT_NEAR(glm::dot(s.lowerNormal, tangent), 0.0, rounding);
}

TEST(Analytic, ThicknessStaysBetweenItsBoundsAndItsGradientIsTheSlope)
{
    Material material;
    material.thicknessLeastNm = 100.0;
    material.thicknessMostNm = 300.0;
    double least = 1e9, most = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const dvec3 p(0.013 * i, 0.007 * i - 50.0, 0.003 * i);
        const double d = surface(material, {0, 0, 1}, {1, 0, 0, 1}, p)->thicknessNm;
        ASSERT_GE(d, 100.0);
        ASSERT_LE(d, 300.0);
        least = std::min(least, d);
        most = std::max(most, d);
    }
    EXPECT_LT(least, 105.0);  // the noise uses the whole range
    EXPECT_GT(most, 295.0);

    // The correlated lower normal leans along the slope, found here by differences.
    material.lowerNormal = LowerNormal::gradient;
    material.deviationDegrees = 10.0;
    const dvec3 p(0.31, 0.72, 0.11);
    const double step = 1e-5;
    const auto thickness = [&](dvec3 at) { return surface(material, {0, 0, 1}, {1, 0, 0, 1}, at)->thicknessNm; };
    const double slopeX = thickness(p + dvec3(step, 0, 0)) - thickness(p - dvec3(step, 0, 0));
    const double slopeY = thickness(p + dvec3(0, step, 0)) - thickness(p - dvec3(0, step, 0));
    const dvec3 n1 = surface(material, {0, 0, 1}, {1, 0, 0, 1}, p)->lowerNormal;
    EXPECT_NEAR(n1.x * slopeY - n1.y * slopeX, 0.0, 1e-6 * std::hypot(slopeX, slopeY));
    EXPECT_GT(n1.x * slopeX + n1.y * slopeY, 0.0);
}

}  // namespace
