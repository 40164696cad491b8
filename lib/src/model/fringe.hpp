#pragma once

#include <array>

#include <glm/gtc/constants.hpp>
#include <glm/vec4.hpp>

#include "material.hpp"

namespace nacre::model {

constexpr int defaultOrders = 2;  // NACRE_ORDERS, shaders/nacre_config.glsl

// Of any number of orders, which the shaders fix at compile time.
template <std::size_t Orders>
struct Fringe {
    std::array<dvec3, Orders> order;
    double coherence;
};

inline const dvec4 fringeLines(2.21777322, 1.90322369, 1.80066289, 1.65613586);
inline const dvec4 fringeDecay(-0.326053914, -0.597588231, -0.333458856, -0.182555639);
inline const dvec4 fringeRed(0.144105461, -0.766282724, -0.123086929, 1.74525443);
inline const dvec4 fringeGreen(-0.142321879, 0.457108368, 0.991535075, -0.306281223);
inline const dvec4 fringeBlue(1.11180163, 0.0629806261, -0.182909394, 0.00815675084);

inline dvec4 linePhase(double path)
{
    const dvec4 cycles = fringeLines * path;
    return glm::two_pi<double>() * (cycles - floor(cycles + 0.5));
}

inline dvec3 ofLines(dvec4 line)
{
    return dvec3(dot(fringeRed, line), dot(fringeGreen, line), dot(fringeBlue, line));
}

template <std::size_t Orders>
Fringe<Orders> lineHarmonics(double path, dvec4 cosine, dvec4 first, dvec4 zeroth)
{
    Fringe<Orders> f;
    dvec4 decay = exp2(fringeDecay * (path * path));
    const dvec4 decaySquared = decay * decay;
    dvec4 decayStep = decay;
    dvec4 wave = first, before = zeroth;
    for (std::size_t m = 0; m < Orders; ++m) {
        f.order[m] = ofLines(wave * decay);
        f.coherence = decay.y;
        const dvec4 next = 2.0 * cosine * wave - before;
        before = wave;
        wave = next;
        decayStep *= decaySquared;
        decay *= decayStep;
    }
    return f;
}

template <std::size_t Orders>
Fringe<Orders> cosineFringe(double path)
{
    const dvec4 cosine = cos(linePhase(path));
    return lineHarmonics<Orders>(path, cosine, cosine, dvec4(1.0));
}

template <std::size_t Orders>
Fringe<Orders> sineFringe(double path)
{
    const dvec4 phase = linePhase(path);
    return lineHarmonics<Orders>(path, cos(phase), sin(phase), dvec4(0.0));
}

inline dvec3 firstFringeOf(double path)
{
    return ofLines(cos(linePhase(path)) * exp2(fringeDecay * (path * path)));
}

inline dvec3 firstFringe(dvec3 path)
{
    return {firstFringeOf(path.x).x, firstFringeOf(path.y).y, firstFringeOf(path.z).z};
}

}  // namespace nacre::model
