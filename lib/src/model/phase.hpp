#pragma once

#include <glm/gtc/constants.hpp>

#include "material.hpp"

namespace nacre::model {

// Double precision has bits to spare: the path stays in one part, and whole cycles stay in it.
struct Path {
    dvec3 head;
};

inline Path path(dvec3 cyclesPerUm, double thicknessUm)
{
    return {cyclesPerUm * thicknessUm};
}

// Eq 3; Φ is π times this.
inline dvec3 pathCycles(Path path, dvec3 cosSum)
{
    return path.head * cosSum;
}

inline dvec3 cosPhase(dvec3 cycles)
{
    const dvec3 y = 0.5 - abs(cycles - floor(cycles + 0.5));
    return sin(glm::pi<double>() * y);
}

}  // namespace nacre::model
