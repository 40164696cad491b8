#include "material.hpp"

#include "diffuse.hpp"

namespace nacre::model {

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

    m.lowerNormal = static_cast<int>(material.lowerNormal);
    m.deviationCos = std::cos(glm::radians(material.deviationDegrees));
    m.deviationSin = std::sin(glm::radians(material.deviationDegrees));
    m.azimuthCos = std::cos(glm::radians(material.azimuthDegrees));
    m.azimuthSin = std::sin(glm::radians(material.azimuthDegrees));
    return m;
}

}  // namespace nacre::model
