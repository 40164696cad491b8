#pragma once

#include "direction.hpp"
#include "noise.hpp"

namespace nacre::model {

// nacre_thickness.glsl

inline dvec4 thickness(const Material& m, dvec3 p)
{
    if (m.noiseOctaves < 1 || !(m.noiseFrequency > 0.0)) {
        return dvec4(0.0, 0.0, 0.0, 0.5 * (m.thicknessLeastUm + m.thicknessMostUm));
    }
    const dvec4 noise = turbulence(p * m.noiseFrequency, m.noiseOctaves, m.noiseSeed);
    const double height = glm::clamp(1.23 * noise.w, -1.0, 1.0);
    const double share = 0.5 + height * (0.75 - 0.25 * height * height);
    const dvec3 gradient = dvec3(noise) * (1.0 - height * height);
    const double thickness = glm::mix(m.thicknessLeastUm, m.thicknessMostUm, share);
    return dvec4(gradient, thickness >= m.thicknessLeastUm ? std::fmin(thickness, m.thicknessMostUm) : m.thicknessLeastUm);
}

// nacre_lower_normal.glsl

inline dvec3 lowerNormalConstant(const Material& m, dvec3 upperNormal, dvec3 tangent, double handedness)
{
    dvec3 x, y;
    frame(upperNormal, x, y);
    dvec3 along = direction(tangent - upperNormal * dot(upperNormal, tangent));
    along = dot(along, along) > 0.0 ? along : x;
    const dvec3 across = cross(upperNormal, along) * handedness;
    return upperNormal * m.deviationCos + (along * m.azimuthCos + across * m.azimuthSin) * m.deviationSin;
}

inline dvec3 lowerNormalGradient(const Material& m, dvec3 upperNormal, dvec3 gradient)
{
    const dvec3 along = gradient - upperNormal * dot(upperNormal, gradient);
    const dvec3 across = cross(upperNormal, along);
    return direction(upperNormal * m.deviationCos + (along * m.azimuthCos + across * m.azimuthSin) * m.deviationSin);
}

inline dvec3 independentGradient(const Material& m, dvec3 p)
{
    return dvec3(turbulence(p * m.noiseFrequency, m.noiseOctaves, m.noiseSeed + 7919));
}

// nacre_surface.glsl

inline Surface surface(const Material& m, dvec3 upperNormal, dvec4 tangent, dvec3 objectPosition, const glm::dmat3& normalToShading)
{
    Surface s;
    s.upperNormal = direction(upperNormal);
    s.lowerNormal = s.upperNormal;
    const dvec4 t = thickness(m, objectPosition);
    s.thicknessUm = t.w;
    if (m.lowerNormal == static_cast<int>(LowerNormal::constant)) {
        s.lowerNormal = lowerNormalConstant(m, s.upperNormal, dvec3(tangent), tangent.w);
    } else if (m.lowerNormal == static_cast<int>(LowerNormal::independent)) {
        const dvec3 gradient = normalToShading * independentGradient(m, objectPosition);
        s.lowerNormal = lowerNormalGradient(m, s.upperNormal, gradient);
    } else if (m.lowerNormal == static_cast<int>(LowerNormal::gradient)) {
        s.lowerNormal = lowerNormalGradient(m, s.upperNormal, normalToShading * dvec3(t));
    }
    return s;
}

}  // namespace nacre::model
