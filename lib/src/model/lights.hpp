#pragma once

#include <cmath>

#include <glm/trigonometric.hpp>

#include <nacre/lights.hpp>

#include "direction.hpp"

namespace nacre::model {

// nacre_lights.glsl

struct LightSource {
    dvec3 colour;
    double inverseRange;
    dvec3 position;
    LightKind kind;
    dvec3 direction;
    double angleScale;
    double angleOffset;
};

struct Incidence {
    dvec3 direction;
    dvec3 radiance;
};

// What the host computes of a light, once. The extension keeps the cones 0.001 apart, in cosine.
inline LightSource derive(const nacre::LightSource& light)
{
    LightSource source{};
    source.colour = light.colour * light.intensity;
    source.kind = light.kind;
    const bool isPlaced = light.kind != LightKind::directional, isSpot = light.kind == LightKind::spot;
    if (isPlaced) source.position = light.position;
    if (light.kind != LightKind::point) source.direction = direction(light.direction);
    if (isPlaced && light.range > 0.0) source.inverseRange = std::fmin(1.0 / light.range, 1e30);  // a float32
    if (isSpot) {
        const double cosOuter = std::cos(glm::radians(light.outerConeDegrees));
        source.angleScale = 1.0 / std::fmax(0.001, std::cos(glm::radians(light.innerConeDegrees)) - cosOuter);
        source.angleOffset = -cosOuter * source.angleScale;
    } else {
        source.angleOffset = 1.0;
    }
    return source;
}

inline double distanceAttenuation(double squared, double inverseRange)
{
    if (!(squared > 0.0 && squared < 3e38)) return 0.0;
    const double share = squared * inverseRange * inverseRange;
    return std::fmax(1.0 - share * share, 0.0) / std::fmax(squared, 1e-12);
}

inline double angularAttenuation(double cosTheta, double angleScale, double angleOffset)
{
    const double share = glm::clamp(cosTheta * angleScale + angleOffset, 0.0, 1.0);
    return share * share;
}

inline Incidence incidence(const LightSource& source, dvec3 position)
{
    if (source.kind == LightKind::directional) return {-source.direction, source.colour};
    const dvec3 toLight = source.position - position;
    const dvec3 towards = direction(toLight);
    const double attenuation = distanceAttenuation(dot(toLight, toLight), source.inverseRange) *
                               angularAttenuation(-dot(source.direction, towards), source.angleScale, source.angleOffset);
    return {towards, source.colour * attenuation};
}

}  // namespace nacre::model
