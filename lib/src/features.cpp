#include <nacre/features.hpp>

#include <algorithm>
#include <cmath>

#include <nacre/validate.hpp>

#include "form_bounds.hpp"
#include "model/material.hpp"

namespace nacre {
namespace {

bool areEqual(glm::dvec3 a)
{
    return a.r == a.g && a.r == a.b;
}

double greatest(glm::dvec3 a)
{
    return std::max({a.r, a.g, a.b});
}

ThicknessSource thicknessOf(const Material& m, LowerNormals lowerNormals)
{
    const bool isConstant = !model::hasNoise(m) || m.thicknessLeastNm == m.thicknessMostNm;
    return isConstant && lowerNormals != LowerNormals::gradient ? ThicknessSource::constant : ThicknessSource::noise;
}

// Cheap forms as long as their bounds add up to no more than the error.
class Budget {
public:
    Budget(double error, double weight) : left_(error), weight_(weight) {}

    bool affords(double bound)
    {
        const double error = bound * weight_;
        if (!(error <= left_)) return false;
        left_ -= error;
        return true;
    }

private:
    double left_, weight_;
};

void chooseForms(Features& f, const Material& m, const FeatureOptions& options)
{
    Budget budget(options.error, std::max(m.specularWeight, 0.0) + std::max(m.diffuseWeight, 0.0));
    const bool hasPlainLobes = std::min(m.upperExponent, m.lowerExponent) >= bounds::leastPlainExponent && !f.totalReflection;
    f.stableLobes = !(hasPlainLobes && budget.affords(bounds::at(bounds::builtInLobes, std::max(m.upperExponent, m.lowerExponent))));
    // A map may bring any thickness; the material's bounds are what is known of it.
    const double cycles = 2.0 * greatest(m.ior / m.wavelengthNm) * m.thicknessMostNm;
    f.splitPhase = !budget.affords(bounds::at(bounds::wholePhase, cycles));
    f.polynomialCosine = options.machine == Machine::cpu || !budget.affords(bounds::at(bounds::builtInCosine, cycles));
}

}  // namespace

bool operator==(const Features& a, const Features& b) noexcept
{
    return key(a) == key(b);
}

bool operator!=(const Features& a, const Features& b) noexcept
{
    return !(a == b);
}

Result<Features> featuresOf(const Material& material, const FeatureOptions& options)
{
    const std::vector<Fault> faults = validate(material);
    if (!faults.empty()) return Error{"nacre::featuresOf(): " + faults.front().message};
    if (!(options.error >= 0.0)) return Error{"nacre::featuresOf(): expected error >= 0, got " + std::to_string(options.error)};
    if (options.lights < 1) return Error{"nacre::featuresOf(): expected lights >= 1, got " + std::to_string(options.lights)};

    const model::Material m = model::derive(material);
    Features f;
    f.paper = material.quality == Quality::paper;
    f.physical = material.quality == Quality::physical;
    f.specular = material.specularWeight > 0.0;
    f.diffuse = material.diffuseWeight > 0.0 && (f.paper || greatest(material.diffuseAlbedo) > 0.0);
    f.dispersion = !areEqual(material.ior);
    const glm::dvec3 ior = material.ior;
    f.totalReflection = std::min({ior.r, ior.g, ior.b}) < material.iorOutside;
    f.lowerNormals = static_cast<LowerNormals>(m.lowerNormal);
    f.thickness = thicknessOf(material, f.lowerNormals);
    if (options.thicknessMap) {
        f.thickness = ThicknessSource::map;
        f.lowerNormals = options.lowerNormalMap ? LowerNormals::any : LowerNormals::parallel;
    }
    f.metal = m.substrate == 1;
    f.substrateChannels = !areEqual(m.substrateReal) || !areEqual(m.substrateImaginary);
    f.normalised = material.lobes == Lobes::normalised;
    f.fringes = options.fringes;
    f.lights = options.lights;
    chooseForms(f, material, options);
    // What the lobes alone ask for, nothing asks for; what the diffuse part does may become one of a thickness that varies.
    if (!f.specular) {
        f.lowerNormals = LowerNormals::parallel;
        f.totalReflection = f.metal = f.substrateChannels = f.normalised = f.stableLobes = false;
    }
    return f;
}

namespace {

Fringes joinFringes(const Features& a, const Features& b)
{
    if (!a.physical || !b.physical) return a.physical ? a.fringes : b.fringes;
    return a.fringes == b.fringes ? a.fringes : Fringes::either;
}

}  // namespace

Features join(const Features& a, const Features& b) noexcept
{
    Features f;
    f.paper = a.paper || b.paper;
    f.physical = a.physical || b.physical;
    f.specular = a.specular || b.specular;
    f.diffuse = a.diffuse || b.diffuse;
    f.dispersion = a.dispersion || b.dispersion;
    f.totalReflection = a.totalReflection || b.totalReflection;
    f.thickness = std::max(a.thickness, b.thickness);  // noise gives a constant one, a map either
    // Parallel boundaries are those that lean by 0: `pack` says so.
    const auto [less, more] = std::minmax(a.lowerNormals, b.lowerNormals);
    f.lowerNormals = less == more || less == LowerNormals::parallel ? more : LowerNormals::any;
    f.substrateChannels = a.substrateChannels || b.substrateChannels;
    f.metal = a.metal || b.metal;
    f.normalised = a.normalised || b.normalised;
    f.fringes = joinFringes(a, b);
    f.stableLobes = a.stableLobes || b.stableLobes;
    f.splitPhase = a.splitPhase || b.splitPhase;
    f.polynomialCosine = a.polynomialCosine || b.polynomialCosine;
    f.lights = std::max(a.lights, b.lights);
    f.materials = std::max(a.materials, b.materials);
    return f;
}

Features canonical(const Features& features) noexcept
{
    Features f = features;
    if (!f.paper && !f.physical) f.paper = true;
    if (!f.specular && !f.diffuse) f.diffuse = true;
    if (f.paper && f.physical) {
        // A shader of both qualities is meant for whatever comes.
        f.dispersion = f.totalReflection = f.substrateChannels = f.metal = f.normalised = true;
        f.stableLobes = f.splitPhase = f.polynomialCosine = true;
    }
    // A gradient of the thickness is one of noise; so is what may be one.
    const bool mayFollowNoise = f.lowerNormals == LowerNormals::gradient || f.lowerNormals == LowerNormals::any;
    if (f.specular && f.thickness == ThicknessSource::constant && mayFollowNoise) f.thickness = ThicknessSource::noise;
    if (f.thickness == ThicknessSource::map && f.lowerNormals != LowerNormals::parallel) f.lowerNormals = LowerNormals::any;
    if (!f.specular) {
        f.lowerNormals = LowerNormals::parallel;
        f.totalReflection = f.substrateChannels = f.metal = f.normalised = f.stableLobes = false;
    }
    const bool hasPhase = f.specular || f.thickness != ThicknessSource::constant;
    if (!hasPhase) f.dispersion = f.splitPhase = f.polynomialCosine = false;
    if (!f.paper) f.splitPhase = f.polynomialCosine = false;
    if (!f.physical) f.substrateChannels = f.metal = f.normalised = false;
    if (!f.physical || !hasPhase) f.fringes = Fringes::samplerFree;
    if (f.physical && f.specular && (f.dispersion || f.metal)) f.substrateChannels = true;
    f.lights = std::max(f.lights, 1);
    f.materials = std::max(f.materials, 1);
    return f;
}

std::uint64_t key(const Features& features) noexcept
{
    const Features f = canonical(features);
    std::uint64_t bits = 0;
    const auto add = [&](std::uint64_t value, unsigned width) { bits = bits << width | value; };
    add(f.paper, 1);
    add(f.physical, 1);
    add(f.specular, 1);
    add(f.diffuse, 1);
    add(f.dispersion, 1);
    add(f.totalReflection, 1);
    add(static_cast<std::uint64_t>(f.thickness), 2);
    add(static_cast<std::uint64_t>(f.lowerNormals), 3);
    add(f.substrateChannels, 1);
    add(f.metal, 1);
    add(f.normalised, 1);
    add(static_cast<std::uint64_t>(f.fringes), 2);
    add(f.stableLobes, 1);
    add(f.splitPhase, 1);
    add(f.polynomialCosine, 1);
    add(static_cast<std::uint64_t>(f.lights) & 0xFFFFU, 16);
    add(static_cast<std::uint64_t>(f.materials) & 0xFFFFU, 16);
    return bits;
}

std::vector<std::string> describe(const Features& features)
{
    const Features f = canonical(features);
    std::vector<std::string> lines;
    const auto say = [&](bool holds, const char* line) {
        if (holds) lines.emplace_back(line);
    };
    say(f.paper, "quality paper: two beams, three wavelengths");
    say(f.physical && f.fringes != Fringes::samplerFree, "quality physical: a real film, its fringes from a texture");
    say(f.physical && f.fringes == Fringes::samplerFree, "quality physical: a real film");
    say(f.specular, "specular part: two lobes");
    say(f.diffuse && f.thickness == ThicknessSource::constant, "diffuse part: one colour, from the host");
    say(f.diffuse && f.thickness != ThicknessSource::constant, "diffuse part: a colour per pixel");
    say(f.dispersion, "an index per channel");
    say(f.totalReflection, "an index below the outside's: total reflection");
    say(f.thickness == ThicknessSource::constant, "constant thickness");
    say(f.thickness == ThicknessSource::noise, "thickness by noise");
    say(f.thickness == ThicknessSource::map, "thickness from the host, per pixel");
    say(f.specular && f.lowerNormals == LowerNormals::parallel, "parallel boundaries");
    say(f.lowerNormals == LowerNormals::constant, "a lower boundary that leans by one angle");
    say(f.lowerNormals == LowerNormals::independent, "a lower boundary that leans by noise of its own");
    say(f.lowerNormals == LowerNormals::gradient, "a lower boundary that follows the thickness");
    say(f.lowerNormals == LowerNormals::any, "a lower boundary that leans in any way");
    say(f.substrateChannels, "something else below per channel");
    say(f.metal, "a metal below");
    say(f.normalised, "normalised lobes");
    say(f.specular && f.stableLobes, "lobes to the last digit");
    say(f.splitPhase, "phase of a thick layer, in two parts");
    say(f.polynomialCosine, "the library's cosine");
    return lines;
}

}  // namespace nacre
