// Quality physical: analytic limits, reciprocity, energy, in double precision.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <nacre/evaluate.hpp>

#include "model/physical.hpp"
#include "spectral.hpp"

namespace {

using namespace nacre;

constexpr double pi = 3.141592653589793;

double uniform(std::mt19937_64& random, double least, double most)
{
    return least + (most - least) * static_cast<double>(random() >> 11U) * 0x1p-53;
}

glm::dvec3 direction(double cosTheta, double azimuth)
{
    const double sine = std::sqrt(1.0 - cosTheta * cosTheta);
    return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosTheta};
}

const FringeTable& fringeTable()
{
    static const Result<FringeTable> table = FringeTable::create();
    return *table;
}

Material physical(double ior, std::complex<double> substrate)
{
    Material m;
    m.quality = Quality::physical;
    m.ior = glm::dvec3(ior);
    m.substrate = substrate.imag() > 0.0 ? Substrate::metal : Substrate::dielectric;
    m.substrateIndex = glm::dvec3(substrate.real());
    m.substrateAbsorption = glm::dvec3(substrate.imag());
    return m;
}

// A film in the mirror direction at one wavelength, its fringes not faded.
struct OneWavelength {
    model::Film film;
    int kind;
    double cycles;

    OneWavelength(const Material& material, double thicknessNm, double cosTheta, double wavelengthNm)
    {
        Material m = material;
        m.upperExponent = m.lowerExponent = 0.0;
        const model::Material derived = model::derive(m);
        const model::PhysicalView view =
            model::physicalView(derived, {{0, 0, 1}, {0, 0, 1}, thicknessNm / 1000.0}, direction(cosTheta, 0.3), nullptr);
        const model::PhysicalTerms terms = model::physicalTerms(derived, view, direction(cosTheta, 0.3 + pi));
        film = model::filmOf(derived, terms, 0);
        kind = derived.substrate;
        cycles = terms.path[0] * 1000.0 / wavelengthNm;
    }

    // With the closed form after Orders terms.
    template <std::size_t Orders>
    double closed() const
    {
        model::Fringe<Orders> cosine, sine;
        cosine.coherence = sine.coherence = 1.0;
        for (std::size_t m = 0; m < Orders; ++m) {
            cosine.order[m] = glm::dvec3(std::cos(2.0 * pi * cycles * static_cast<double>(m + 1)));
            sine.order[m] = glm::dvec3(std::sin(2.0 * pi * cycles * static_cast<double>(m + 1)));
        }
        const double fringes = kind == 1 ? model::fringeSumMetal(film, cosine, sine, 0) : model::fringeSum(film, cosine).x;
        return model::filmReflectance(film, glm::dvec3(fringes), 1.0, 1.0).x;
    }

    // All orders at once, as the fringe table has them: q F / (1 - |q|²) is the whole series.
    double whole() const
    {
        const std::complex<double> wave = std::polar(1.0, 2.0 * pi * cycles);
        const auto sum = [&](std::complex<double> q) { return (q * wave / (1.0 - q * wave)).real(); };
        const double fringes = film.fringe.x * sum(film.ratio.s) + film.fringe.y * sum(film.ratio.p);
        return model::filmReflectance(film, glm::dvec3(fringes), 1.0, 1.0).x;
    }

    // Cut off after that many terms.
    double truncated(int orders) const
    {
        double sum = film.upper + film.lower;
        for (int m = 1; m <= orders; ++m) {
            const std::complex<double> wave = std::polar(1.0, 2.0 * pi * cycles * m);
            sum += (film.fringe.x * std::pow(film.ratio.s, m) * wave + film.fringe.y * std::pow(film.ratio.p, m) * wave).real();
        }
        return sum;
    }
};

struct RandomFilm {
    double index, thicknessNm, cosTheta, wavelengthNm;
    std::complex<double> substrate;

    explicit RandomFilm(std::mt19937_64& random)
        : index(uniform(random, 1.2, 2.2)), thicknessNm(uniform(random, 0.0, 2000.0)), cosTheta(uniform(random, 0.2, 1.0)),
          wavelengthNm(uniform(random, 400.0, 700.0)),
          substrate(uniform(random, 1.1, 3.0), random() % 2 ? uniform(random, 0.0, 6.0) : 0.0)
    {
    }
    double truth() const { return test::airy(index, substrate, thicknessNm, cosTheta, wavelengthNm).mean(); }
};

// Enough orders: 200, |q| is below 0.85 for these films. 1e-12: the rounding of 200 terms below 1.
TEST(Physical, IsAiryAtOneWavelength)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 2000; ++i) {
        const RandomFilm f(random);
        const OneWavelength one(physical(f.index, f.substrate), f.thicknessNm, f.cosTheta, f.wavelengthNm);
        ASSERT_NEAR(one.whole(), f.truth(), 1e-12) << f.index << " on " << f.substrate << ", " << f.thicknessNm << " nm, " << f.cosTheta;
        ASSERT_NEAR(one.closed<200>(), f.truth(), 1e-12) << f.index << " on " << f.substrate << ", " << f.thicknessNm << " nm, " << f.cosTheta;
    }
}

// A series cut off after M terms lacks at most Σ_{m>M} |G - τ| |q|^m of each polarisation. With its closed form
// a metal's lacks nothing at one wavelength; a dielectric's shares the ratio of s, and stays within the bound.
template <std::size_t Orders>
void checkTruncation(std::mt19937_64& random)
{
    const double rounding = 1e-13;
    double worstCut = 0.0, worstClosed = 0.0;
    for (int i = 0; i < 500; ++i) {
        const RandomFilm f(random);
        const OneWavelength one(physical(f.index, f.substrate), f.thicknessNm, f.cosTheta, f.wavelengthNm);
        const double s = std::abs(one.film.ratio.s), p = std::abs(one.film.ratio.p);
        const double power = static_cast<double>(Orders) + 1.0;
        const double bound = std::fabs(one.film.fringe.x) * std::pow(s, power) / (1.0 - s) + std::fabs(one.film.fringe.y) * std::pow(p, power) / (1.0 - p);
        const double cut = std::fabs(one.truncated(static_cast<int>(Orders)) - f.truth());
        const double closed = std::fabs(one.closed<Orders>() - f.truth());
        EXPECT_LE(cut, bound + rounding);
        EXPECT_LE(closed, (one.kind == 1 ? 0.0 : bound) + rounding);
        worstCut = std::max(worstCut, cut);
        worstClosed = std::max(worstClosed, closed);
    }
    std::printf("%zu orders: cut off %.2g at most, closed %.2g\n", Orders, worstCut, worstClosed);
}

TEST(Physical, TruncationKeepsItsBound)
{
    std::mt19937_64 random(2);
    checkTruncation<1>(random);
    checkTruncation<2>(random);
    checkTruncation<3>(random);
    checkTruncation<4>(random);
}

Material randomMaterial(std::mt19937_64& random)
{
    Material m;
    m.quality = Quality::physical;
    m.iorOutside = random() % 4 ? 1.0 : 1.33;
    for (int channel = 0; channel < 3; ++channel) {
        m.ior[channel] = uniform(random, 0.8, 2.5);
        m.substrateIndex[channel] = uniform(random, 0.1, 4.0);
        m.substrateAbsorption[channel] = uniform(random, 0.0, 6.0);
        m.substrateF0[channel] = uniform(random, 0.0, 1.0);
    }
    m.substrate = static_cast<Substrate>(random() % 3);
    m.lobes = static_cast<Lobes>(random() % 2);
    m.upperExponent = std::pow(10.0, uniform(random, -1.0, 3.0));
    m.lowerExponent = std::pow(10.0, uniform(random, -1.0, 3.0));
    return m;
}

// 1e-12 of the value: the rounding of a lobe's power, exponent times 1e-16.
TEST(Physical, LightAndViewerMayBeSwapped)
{
    std::mt19937_64 random(3);
    int lit = 0;
    for (int i = 0; i < 20000; ++i) {
        const Material m = randomMaterial(random);
        const Surface s{{0, 0, 1}, direction(uniform(random, 0.7, 1.0), uniform(random, 0.0, 6.28)), uniform(random, 0.0, 3000.0)};
        const glm::dvec3 l = direction(uniform(random, 0.02, 1.0), uniform(random, 0.0, 6.28));
        const glm::dvec3 v = direction(uniform(random, 0.02, 1.0), uniform(random, 0.0, 6.28));
        const FringeTable* table = random() % 2 ? &fringeTable() : nullptr;
        const glm::dvec3 there = evaluate(m, s, l, v, table)->rho, back = evaluate(m, s, v, l, table)->rho;
        for (int channel = 0; channel < 3; ++channel) {
            ASSERT_NEAR(there[channel], back[channel], 1e-12 * std::max(there[channel], 1e-3)) << i;
            lit += there[channel] > 1e-6;
        }
    }
    EXPECT_GT(lit, 10000);
}

// The directional albedo of one channel: ∫ ρ cos over the hemisphere, lit from l. Light is sampled from the two
// lobes and from the whole hemisphere, each sample weighed by the mixture of the three densities; the points
// are those of a low-discrepancy sequence (Roberts' R2), so the sum converges like 1/n.
double albedo(const Material& material, const Surface& surface, glm::dvec3 l, const FringeTable* table, int samples = 6000)
{
    const model::Material m = model::derive(material);
    const model::Surface s{surface.upperNormal, surface.lowerNormal, surface.thicknessNm / 1000.0};
    // Reciprocal: the fixed direction serves as the view, which is computed once.
    const model::PhysicalView w = model::physicalView(m, s, l, table);
    const double eta = m.eta.x, e0 = m.upperExponent, e1 = m.lowerExponent;
    const glm::dvec3 n(0, 0, 1), n1 = s.lowerNormal;
    const glm::dvec3 upperMirror = 2.0 * l.z * n - l;
    const auto refract = [&](glm::dvec3 d, double ratio) {  // to a unit vector that still points up; z 0: total reflection
        const double cosSquared = 1.0 - ratio * ratio * (1.0 - d.z * d.z);
        return glm::dvec3(ratio * d.x, ratio * d.y, cosSquared > 0.0 ? std::sqrt(cosSquared) : 0.0);
    };
    const glm::dvec3 inside = refract(l, eta);
    const glm::dvec3 lowerMirror = 2.0 * dot(inside, n1) * n1 - inside;
    const auto around = [](glm::dvec3 axis, double cosine, double azimuth) {
        glm::dvec3 x, y;
        model::frame(axis, x, y);
        const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
        return sine * std::cos(azimuth) * x + sine * std::sin(azimuth) * y + cosine * axis;
    };
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double a = std::fmod(0.5 + 0.7548776662466927 * i, 1.0), b = 2.0 * pi * std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
        for (int strategy = 0; strategy < 3; ++strategy) {
            glm::dvec3 v = around(n, a, b);
            if (strategy == 0) v = around(upperMirror, std::pow(1.0 - a, 1.0 / (e0 + 1.0)), b);
            if (strategy == 1) {
                const glm::dvec3 within = around(lowerMirror, std::pow(1.0 - a, 1.0 / (e1 + 1.0)), b);
                if (within.z <= 0.0) continue;
                v = refract(within, 1.0 / eta);
            }
            if (v.z <= 0.0) continue;
            const glm::dvec3 within = refract(v, eta);
            double density = 1.0 / (2.0 * pi) + (e0 + 1.0) / (2.0 * pi) * std::pow(std::max(dot(v, upperMirror), 0.0), e0);
            if (within.z > 0.0) {
                density += (e1 + 1.0) / (2.0 * pi) * std::pow(std::max(dot(within, lowerMirror), 0.0), e1) * eta * eta * v.z / within.z;
            }
            sum += model::physicalSpecular(m, w, model::physicalTerms(m, w, v), table).x * v.z / density;
        }
    }
    return sum / samples;
}

const std::complex<double> substrates[] = {1.0, 1.5, 4.0, 100.0, {0.05, 4.0}, {0.9, 6.3}, {0.2, 3.4}, {2.9, 3.0}};

// The largest albedo of a layer of that index over substrates, exponents, thicknesses, angles and tilts.
double largestAlbedo(double index, std::mt19937_64& random)
{
    const double exponents[][2] = {{0, 0}, {0.4, 0.4}, {1, 1}, {5, 5}, {20, 20}, {500, 500}, {2000, 20}, {20, 2000}, {0, 300}, {3000, 3000}};
    double most = 0.0;
    for (const std::complex<double>& substrate : substrates) {
        for (const auto& exponent : exponents) {
            for (int i = 0; i < 3; ++i) {
                // Sanitizers look for undefined behaviour, which the fifth part of the cases shows as well.
                if (NACRE_SANITIZED && random() % 5 != 0) continue;
                Material m = physical(index, substrate);
                m.lobes = Lobes::normalised;
                m.upperExponent = exponent[0];
                m.lowerExponent = exponent[1];
                const double cosTheta = i == 0 ? 1.0 : uniform(random, 0.05, 1.0);
                const double tilt = i == 2 ? uniform(random, 0.0, 0.5) : 0.0;
                const Surface s{{0, 0, 1}, direction(std::cos(tilt), uniform(random, 0.0, 6.28)), uniform(random, 0.0, 900.0)};
                most = std::max(most, albedo(m, s, direction(cosTheta, 0.0), i == 1 ? &fringeTable() : nullptr));
            }
        }
    }
    return most;
}

// 1e-3: what the sampling errs. Mostly it is far below 1: light is lost at the horizon, in the metal, and
// between lobes that do not cover each other.
TEST(Physical, FurnaceGivesBackNoMoreThanItGot)
{
    std::mt19937_64 random(4);
    for (double index : {0.5, 0.7, 0.9, 1.0, 1.05, 1.3, 1.8, 3.0, 10.0}) EXPECT_LE(largestAlbedo(index, random), 1.0 + 1e-3) << "index " << index;
}

// A mirror below a layer of the outside's index, smooth: all of the light comes back.
TEST(Physical, SmoothMirrorGivesBackNearlyEverything)
{
    Material m = physical(1.0, {0.01, 50.0});
    m.lobes = Lobes::normalised;
    m.upperExponent = m.lowerExponent = 5000.0;
    EXPECT_NEAR(albedo(m, {{0, 0, 1}, {0, 0, 1}, 300.0}, direction(1.0, 0.0), nullptr), 1.0, 2e-3);
}

// Below the outside's index, beyond the critical angle: a mirror, whatever lies below.
TEST(Physical, TotalReflectionReflectsAll)
{
    Material m = physical(0.6, 2.0);
    m.upperExponent = m.lowerExponent = 0.0;
    const glm::dvec3 l = direction(0.3, 0.0), v = direction(0.3, pi);
    const Evaluation e = *evaluate(m, {{0, 0, 1}, {0, 0, 1}, 300.0}, l, v);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_EQ(e.rho[channel], 1.0);
        EXPECT_EQ(e.T[channel], 0.0);
    }
}

// A layer that is not there: the bare substrate's Fresnel reflectance. A layer of the substrate's index too.
TEST(Physical, LayerThatMakesNoDifference)
{
    for (double cosTheta : {0.1, 0.5, 1.0}) {
        for (const double index : {1.0, 1.7}) {
            Material m = physical(index, 1.7);
            m.upperExponent = m.lowerExponent = 0.0;
            const Evaluation e = *evaluate(m, {{0, 0, 1}, {0, 0, 1}, 400.0}, direction(cosTheta, 0.0), direction(cosTheta, pi));
            EXPECT_NEAR(e.rho.r, test::airy(1.7, 1.7, 0.0, cosTheta, 500.0).mean(), 1e-14);
        }
    }
}

// F0 is the bare object's reflectance in air; a metal without absorption is a dielectric.
TEST(Physical, KindsOfSubstrateAgree)
{
    Material byIndex = physical(1.3, 1.5);
    Material byColour = byIndex;
    byColour.substrate = Substrate::f0;
    byColour.substrateF0 = glm::dvec3(0.04);  // (0.5 / 2.5)²
    Material asMetal = byIndex;
    asMetal.substrate = Substrate::metal;
    const Surface s{{0, 0, 1}, {0, 0, 1}, 350.0};
    const glm::dvec3 l = direction(0.7, 0.0), v = direction(0.7, pi);
    for (const FringeTable* table : {static_cast<const FringeTable*>(nullptr), &fringeTable()}) {
        const glm::dvec3 expected = evaluate(byIndex, s, l, v, table)->rho;
        EXPECT_NEAR(evaluate(byColour, s, l, v, table)->rho.g, expected.g, 1e-14);
EXPECT_EQ(evaluate(asMetal, s, l, v, table)->rho.g, expected.g);
    }
}

TEST(Physical, DiffusePartNeverExceedsItsAlbedo)
{
    std::mt19937_64 random(5);
    for (int i = 0; i < 5000; ++i) {
        Material m = randomMaterial(random);
        m.ior = max(m.ior, m.iorOutside);
        m.diffuseAlbedo = {0.9, 0.5, 0.1};
        const Surface s{{0, 0, 1}, {0, 0, 1}, uniform(random, 0.0, 3000.0)};
        const glm::dvec3 diffuse = evaluate(m, s, direction(0.5, 0.0), direction(0.9, 1.0), i % 2 ? &fringeTable() : nullptr)->diffuse * pi;
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_GE(diffuse[channel], 0.0);
            EXPECT_LE(diffuse[channel], m.diffuseAlbedo[channel] * (1.0 + 1e-15));
        }
    }
}

TEST(FringeTable, StartsAtOneAndEndsAtNothing)
{
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(fringeTable().look(0.0, 0.0)[channel], 1.0, 1.1e-3);  // 1 - q², where q is half a row from 0
        EXPECT_NEAR(fringeTable().look(0.0, 0.0, 2)[channel], 0.0, 1e-6);   // float texels
        EXPECT_NEAR(fringeTable().look(1000.0, 0.0)[channel], 0.0, 1e-6);
    }
    EXPECT_EQ(fringeTable().texels().size(), std::size_t{FringeTable::width} * FringeTable::height * 4);
}

// The residual that nacre_fringe.glsl states.
TEST(FringeTable, LinesWithoutASamplerKeepTheirResidual)
{
    const glm::dvec3 most(0.077, 0.042, 0.039);
    for (int i = 0; i < 6000; ++i) {
        const double path = i / 1000.0;
        const glm::dvec3 cosine = model::cosineFringe<1>(path).order[0] - fringeTable().look(path, 0.0, 0);
        const glm::dvec3 sine = model::sineFringe<1>(path).order[0] + fringeTable().look(path, 0.0, 2);  // a quarter turn: -sin
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_LE(std::hypot(cosine[channel], sine[channel]), most[channel] + 0.003) << path;  // 0.003: the table's own, linear
        }
    }
}

// Every texel is the integral over the spectrum of the whole series, here in closed form and by the tests' own observer.
// 1e-6: texels are floats.
TEST(FringeTable, SumsAllOrders)
{
    const test::Observer observer;
    std::mt19937_64 random(6);
    for (int i = 0; i < 3000; ++i) {
        const int column = static_cast<int>(random() % (FringeTable::width - 1)), phase = static_cast<int>(random() % FringeTable::phases);
        const int row = 1 + static_cast<int>(random() % (FringeTable::rows - 2));
        const double root = static_cast<double>(column) / (FringeTable::width - 1), q = 2.0 * row / (FringeTable::rows - 1) - 1.0;
        const double path = FringeTable::rangeUm * root * root;
        glm::dvec3 expected(0.0);
        for (std::size_t nm = 0; nm < observer.curves().size(); ++nm) {
            const double wavelengthUm = (360.0 + static_cast<double>(nm)) / 1000.0;
            const std::complex<double> wave = std::polar(1.0, 2.0 * pi * path / wavelengthUm + pi / FringeTable::phases * phase);
            expected += observer.curves()[nm] * ((1.0 - q * q) * wave / (1.0 - q * wave)).real();
        }
        const glm::dvec3 got = fringeTable().look(path, q, phase);
        for (int channel = 0; channel < 3; ++channel) ASSERT_NEAR(got[channel], expected[channel], 1e-6) << path << ' ' << q << ' ' << phase;
    }
}

TEST(FringeTable, OtherPrimariesAndLights)
{
    FringeOptions p3;
    p3.red = {0.680, 0.320};
    p3.green = {0.265, 0.690};
    p3.light.assign(471, 3.0);
    const Result<FringeTable> table = FringeTable::create(p3);
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_NEAR(table->look(0.0, 0.0).g, 1.0, 1.1e-3);
}

TEST(FringeTable, FaultsAreErrors)
{
    const auto message = [](const FringeOptions& options) { return FringeTable::create(options).error().message; };
    FringeOptions o;
    o.green = o.red;
    EXPECT_EQ(message(o), "nacre::FringeTable::create(): expected three primaries that are not on one line");
    o = {};
    o.white.y = 0.0;
    EXPECT_EQ(message(o), "nacre::FringeTable::create(): expected finite chromaticities with y > 0");
    o = {};
    o.light = {1.0, 2.0};
    EXPECT_EQ(message(o), "nacre::FringeTable::create(): expected a light of 471 values or none, got 2");
    o.light.assign(471, -1.0);
    EXPECT_EQ(message(o), "nacre::FringeTable::create(): expected a light of finite values >= 0");
    o.light.assign(471, 0.0);
    EXPECT_EQ(message(o), "nacre::FringeTable::create(): expected a light that is not dark from 400 to 700 nm");
}

}  // namespace
