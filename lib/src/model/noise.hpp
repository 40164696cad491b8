#pragma once

#include <cstdint>

#include <glm/vec4.hpp>

#include "material.hpp"

namespace nacre::model {

using glm::ivec3;

constexpr int maxOctaves = 8;  // NACRE_MAX_OCTAVES, shaders/nacre_config.glsl

inline std::uint32_t hash(ivec3 cell, int seed)
{
    const auto word = [](int value) { return static_cast<std::uint32_t>(value); };
    std::uint32_t h = word(cell.x & 65535) * 73856093u ^ word(cell.y & 65535) * 19349663u ^ word(cell.z & 65535) * 83492791u ^ word(seed) * 2654435769u;
    h = (h ^ (h >> 16u)) * 2246822507u;
    h = (h ^ (h >> 13u)) * 3266489909u;
    return h ^ (h >> 16u);
}

inline dvec3 edgeGradient(std::uint32_t h)
{
    const double a = (h & 1u) == 0u ? 1.0 : -1.0;
    const double b = (h & 2u) == 0u ? 1.0 : -1.0;
    const std::uint32_t axis = (h >> 2u) % 3u;
    return axis == 0u ? dvec3(0.0, a, b) : axis == 1u ? dvec3(a, 0.0, b) : dvec3(a, b, 0.0);
}

inline dvec4 cornerRamp(ivec3 cell, int seed, dvec3 offset)
{
    const dvec3 gradient = edgeGradient(hash(cell, seed));
    return dvec4(gradient, dot(gradient, offset));
}

inline dvec4 noise(dvec3 p, int seed)
{
    const dvec3 corner = floor(p);
    const dvec3 t = p - corner;
    const ivec3 cell(corner - 65536.0 * floor(corner / 65536.0));

    const dvec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    const dvec3 slope = 30.0 * t * t * (t * (t - 2.0) + 1.0);

    const dvec4 n000 = cornerRamp(cell, seed, t);
    const dvec4 n100 = cornerRamp(cell + ivec3(1, 0, 0), seed, t - dvec3(1.0, 0.0, 0.0));
    const dvec4 n010 = cornerRamp(cell + ivec3(0, 1, 0), seed, t - dvec3(0.0, 1.0, 0.0));
    const dvec4 n110 = cornerRamp(cell + ivec3(1, 1, 0), seed, t - dvec3(1.0, 1.0, 0.0));
    const dvec4 n001 = cornerRamp(cell + ivec3(0, 0, 1), seed, t - dvec3(0.0, 0.0, 1.0));
    const dvec4 n101 = cornerRamp(cell + ivec3(1, 0, 1), seed, t - dvec3(1.0, 0.0, 1.0));
    const dvec4 n011 = cornerRamp(cell + ivec3(0, 1, 1), seed, t - dvec3(0.0, 1.0, 1.0));
    const dvec4 n111 = cornerRamp(cell + ivec3(1, 1, 1), seed, t - dvec3(1.0, 1.0, 1.0));

    const dvec4 x00 = mix(n000, n100, fade.x), x10 = mix(n010, n110, fade.x);
    const dvec4 x01 = mix(n001, n101, fade.x), x11 = mix(n011, n111, fade.x);
    const dvec4 y0 = mix(x00, x10, fade.y), y1 = mix(x01, x11, fade.y);
    dvec4 noise = mix(y0, y1, fade.z);

    using glm::mix;
    const double alongX = mix(mix(n100.w - n000.w, n110.w - n010.w, fade.y), mix(n101.w - n001.w, n111.w - n011.w, fade.y), fade.z);
    const double alongY = mix(x10.w - x00.w, x11.w - x01.w, fade.z);
    const double alongZ = y1.w - y0.w;
    noise += dvec4(slope * dvec3(alongX, alongY, alongZ), 0.0);
    return noise;
}

inline dvec4 turbulence(dvec3 p, int octaves, int seed)
{
    dvec4 sum(0.0);
    double frequency = 1.0, amplitude = 1.0, total = 0.0;
    for (int octave = 0; octave < maxOctaves; ++octave) {
        if (octave >= octaves) break;
        const dvec4 n = noise(p * frequency, seed + octave);
        sum += dvec4(dvec3(n) * frequency, n.w) * amplitude;
        total += amplitude * amplitude;
        frequency *= 2.0;
        amplitude *= 0.5;
    }
    return sum / std::sqrt(std::fmax(total, 1.0));
}

}  // namespace nacre::model
