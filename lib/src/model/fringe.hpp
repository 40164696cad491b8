#pragma once

#include <array>

#include <glm/gtc/constants.hpp>
#include <glm/vec4.hpp>

#include <nacre/fringe_table.hpp>

#include "material.hpp"

namespace nacre::model {

constexpr int defaultOrders = 2;  // NACRE_ORDERS, shaders/nacre_config.glsl

// Of any number of orders, which the shaders fix at compile time.
template <std::size_t Orders>
struct Fringe {
    std::array<dvec3, Orders> order;
    dvec3 coherence;
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

template <std::size_t Orders>
Fringe<Orders> lineHarmonics(double path, dvec4 cosine, dvec4 first, dvec4 zeroth)
{
    Fringe<Orders> f;
    dvec4 decay = exp2(fringeDecay * (path * path));
    const dvec4 decaySquared = decay * decay;
    dvec4 decayStep = decay;
    dvec4 wave = first, before = zeroth;
    for (std::size_t m = 0; m < Orders; ++m) {
        const dvec4 line = wave * decay;
        f.order[m] = dvec3(dot(fringeRed, line), dot(fringeGreen, line), dot(fringeBlue, line));
        f.coherence = dvec3(decay.y);
        const dvec4 next = 2.0 * cosine * wave - before;
        before = wave;
        wave = next;
        decayStep *= decaySquared;
        decay *= decayStep;
    }
    return f;
}

template <std::size_t Orders>
Fringe<Orders> cosineFringeAt(double path)
{
    const dvec4 cosine = cos(linePhase(path));
    return lineHarmonics<Orders>(path, cosine, cosine, dvec4(1.0));
}

template <std::size_t Orders>
Fringe<Orders> sineFringeAt(double path)
{
    const dvec4 phase = linePhase(path);
    return lineHarmonics<Orders>(path, cos(phase), sin(phase), dvec4(0.0));
}

template <std::size_t Orders>
Fringe<Orders> perChannel(Fringe<Orders> r, const Fringe<Orders>& g, const Fringe<Orders>& b)
{
    for (std::size_t m = 0; m < Orders; ++m) r.order[m] = dvec3(r.order[m].x, g.order[m].y, b.order[m].z);
    r.coherence = dvec3(r.coherence.x, g.coherence.y, b.coherence.z);
    return r;
}

// nacre_fringe_table.glsl

template <std::size_t Orders>
Fringe<Orders> fringeAt(const FringeTable& table, double path, FringeTable::Row row)
{
    Fringe<Orders> f;
    for (std::size_t m = 0; m < Orders; ++m) {
        const dvec4 texel = table.look(path * static_cast<double>(m + 1), row);
        f.order[m] = dvec3(texel);
        f.coherence = dvec3(std::fmax(texel.w, 0.0));
    }
    return f;
}

// Without a table: the four lines.

template <std::size_t Orders>
Fringe<Orders> cosineFringe(const FringeTable* table, dvec3 path)
{
    constexpr auto row = FringeTable::Row::cosine;
    return table ? perChannel(fringeAt<Orders>(*table, path.x, row), fringeAt<Orders>(*table, path.y, row), fringeAt<Orders>(*table, path.z, row))
                 : perChannel(cosineFringeAt<Orders>(path.x), cosineFringeAt<Orders>(path.y), cosineFringeAt<Orders>(path.z));
}

template <std::size_t Orders>
Fringe<Orders> sineFringe(const FringeTable* table, dvec3 path)
{
    constexpr auto row = FringeTable::Row::sine;
    return table ? perChannel(fringeAt<Orders>(*table, path.x, row), fringeAt<Orders>(*table, path.y, row), fringeAt<Orders>(*table, path.z, row))
                 : perChannel(sineFringeAt<Orders>(path.x), sineFringeAt<Orders>(path.y), sineFringeAt<Orders>(path.z));
}

}  // namespace nacre::model
