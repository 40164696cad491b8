#include <nacre/block.hpp>

#include <cmath>
#include <cstring>

#include <nacre/validate.hpp>

#include "model/layered.hpp"
#include "model/physical.hpp"

namespace nacre {
namespace {

void store(float (&target)[3], glm::dvec3 value)
{
    for (int channel = 0; channel < 3; ++channel) target[channel] = static_cast<float>(value[channel]);
}

// The float nearest to value among those whose last 12 bits of significand are 0: the product with
// another such float is exact.
double head(double value)
{
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::round(std::ldexp(fraction, 12)), exponent - 12);
}

// What nacre_thickness gives where there is no noise; with noise it means something where the bounds are equal.
double constantThicknessUm(const Material& material)
{
    return 0.5 * (material.thicknessLeastNm + material.thicknessMostNm) / 1000.0;
}

glm::dvec3 paperDiffuse(const model::Material& m, double thicknessUm)
{
    const glm::dvec3 cosPhase = model::cosPhase(model::pathCycles(model::path(m.cyclesPerUm, thicknessUm), glm::dvec3(2.0)));
    return m.diffuseWeight * model::diffuseCoefficient(m.diffuseFringe, cosPhase);
}

}  // namespace

Result<Block> pack(const Material& material, const FringeTable* fringeTable)
{
    const std::vector<Fault> faults = validate(material);
    if (!faults.empty()) return Error{"nacre::pack(): " + faults.front().message};

    const model::Material m = model::derive(material);
    const glm::dvec3 cyclesHead(head(m.cyclesPerUm.r), head(m.cyclesPerUm.g), head(m.cyclesPerUm.b));

    Block block{};
    store(block.eta, m.eta);
    store(block.etaSquared, m.etaSquared);
    store(block.oneMinusEtaSquared, m.oneMinusEtaSquared);
    store(block.normalReflectance, m.normalReflectance);
    store(block.cyclesPerUm, cyclesHead);
    store(block.cyclesPerUmTail, m.cyclesPerUm - cyclesHead);
    store(block.diffuseFringe, m.diffuseFringe);
    block.upperExponent = static_cast<float>(m.upperExponent);
    block.lowerExponent = static_cast<float>(m.lowerExponent);
    block.specularWeight = static_cast<float>(m.specularWeight);
    block.diffuseWeight = static_cast<float>(m.diffuseWeight);
    block.thicknessLeastUm = static_cast<float>(m.thicknessLeastUm);
    block.thicknessMostUm = static_cast<float>(m.thicknessMostUm);
    block.noiseFrequency = static_cast<float>(m.noiseFrequency);
    block.deviationCos = static_cast<float>(m.deviationCos);
    block.deviationSin = static_cast<float>(m.deviationSin);
    block.azimuthCos = static_cast<float>(m.azimuthCos);
    block.azimuthSin = static_cast<float>(m.azimuthSin);
    block.noiseOctaves = m.noiseOctaves;
    block.noiseSeed = m.noiseSeed;
    block.lowerNormal = m.lowerNormal;
    block.quality = m.quality;
    store(block.index, m.index);
    block.upperScale = static_cast<float>(m.upperScale);
    store(block.substrateReal, m.substrateReal);
    block.lowerScale = static_cast<float>(m.lowerScale);
    store(block.substrateImaginary, m.substrateImaginary);
    block.substrate = m.substrate;
    store(block.diffuseAlbedo, m.diffuseAlbedo);
    block.lobes = m.lobes;

    const double thicknessUm = constantThicknessUm(material);
    const glm::dvec3 cycles = m.cyclesPerUm * thicknessUm;
    const glm::dvec3 pathHead(head(cycles.r), head(cycles.g), head(cycles.b));
    store(block.diffuse, material.quality == Quality::physical ? model::physicalDiffuse(m, thicknessUm, fringeTable) : paperDiffuse(m, thicknessUm));
    block.thicknessUm = static_cast<float>(thicknessUm);
    store(block.pathHead, pathHead);
    store(block.pathTail, cycles - pathHead);
    return block;
}

}  // namespace nacre
