#include "material.hpp"

#include <glm/gtc/constants.hpp>

#include "diffuse.hpp"

namespace nacre::model {
namespace {

// The index of a dielectric that reflects f0 at normal incidence in air, as engines do. A perfect mirror
// would need an infinite one: 0.9999, an index of 40,000, stands for it.
dvec3 indexFromF0(dvec3 f0)
{
    const dvec3 root = sqrt(min(f0, dvec3(0.9999)));
    return (1.0 + root) / (1.0 - root);
}

void deriveSubstrate(Material& m, const nacre::Material& material)
{
    const bool isMetal = material.substrate == Substrate::metal;
    const dvec3 n = material.substrate == Substrate::f0 ? indexFromF0(material.substrateF0) : material.substrateIndex;
    const dvec3 k = isMetal ? material.substrateAbsorption : dvec3(0.0);
    const dvec3 r1Squared = material.ior * material.ior;
    m.substrateReal = (n - k) * (n + k) / r1Squared;
    m.substrateImaginary = 2.0 * n * k / r1Squared;
    m.substrate = k != dvec3(0.0) ? 1 : 0;  // a metal that does not absorb is a dielectric
}

// Boundaries that lean by nothing are parallel. Beyond 90 degrees a lower normal without a gradient to follow points the
// other way, which is no such case.
LowerNormal lowerNormalOf(const nacre::Material& m)
{
    const bool isUpright = m.deviationDegrees < 90.0;
    const bool leansNowhere = m.deviationDegrees == 0.0 || (m.lowerNormal == LowerNormal::independent && m.noiseOctaves < 1 && isUpright) ||
                              (m.lowerNormal == LowerNormal::gradient && !hasNoise(m) && isUpright);
    return leansNowhere ? LowerNormal::parallel : m.lowerNormal;
}

}  // namespace

bool hasNoise(const nacre::Material& material)
{
    return material.noiseOctaves >= 1 && material.noiseFrequency > 0.0;
}

Material derive(const nacre::Material& material)
{
    const dvec3 r0(material.iorOutside);
    const dvec3 r1 = material.ior;

    Material m{};
    m.eta = r0 / r1;
    m.etaSquared = m.eta * m.eta;
    m.oneMinusEtaSquared = (r1 - r0) * (r1 + r0) / (r1 * r1);  // as a product: exact to the last bits near r1 = r0
    const dvec3 ratio = (r0 - r1) / (r0 + r1);
    m.normalReflectance = ratio * ratio;  // Eq 8
    m.cyclesPerUm = r1 / material.wavelengthNm * 1000.0;
    const dvec3 Td = diffuseTransmittance(m.normalReflectance);
    m.diffuseFringe = 2.0 * sqrt(Td * (1.0 - Td));

    m.upperExponent = material.upperExponent;
    m.lowerExponent = material.lowerExponent;
    m.specularWeight = material.specularWeight;
    m.diffuseWeight = material.diffuseWeight;

    m.thicknessLeastUm = material.thicknessLeastNm / 1000.0;
    m.thicknessMostUm = material.thicknessMostNm / 1000.0;
    m.noiseFrequency = material.noiseFrequency;
    m.noiseOctaves = material.noiseOctaves;
    m.noiseSeed = material.noiseSeed;

    m.quality = static_cast<int>(material.quality);
    m.index = r1;
    deriveSubstrate(m, material);
    m.diffuseAlbedo = material.diffuseAlbedo;
    m.lobes = static_cast<int>(material.lobes);
    const bool isNormalised = material.lobes == Lobes::normalised;
    m.upperScale = isNormalised ? std::sqrt((m.upperExponent + 2.0) / glm::two_pi<double>()) : 1.0;
    m.lowerScale = isNormalised ? std::sqrt((m.lowerExponent + 2.0) / glm::two_pi<double>()) : 1.0;

    const LowerNormal lowerNormal = lowerNormalOf(material);
    m.lowerNormal = static_cast<int>(lowerNormal);
    // A shader that knows only of boundaries that lean takes parallel ones as such, leaning by 0.
    const double deviation = lowerNormal == LowerNormal::parallel ? 0.0 : glm::radians(material.deviationDegrees);
    m.deviationCos = std::cos(deviation);
    m.deviationSin = std::sin(deviation);
    m.azimuthCos = std::cos(glm::radians(material.azimuthDegrees));
    m.azimuthSin = std::sin(glm::radians(material.azimuthDegrees));
    return m;
}

}  // namespace nacre::model
