#pragma once

#include <glm/gtc/constants.hpp>

#include "material.hpp"

namespace nacre::model {

// Eq 3; Φ is π times this.
inline dvec3 pathCycles(dvec3 cyclesAtNormal, dvec3 cosTi, dvec3 cosTo)
{
    return cyclesAtNormal * (cosTi + cosTo);
}

inline dvec3 cosPhase(dvec3 cycles)
{
    const dvec3 y = 0.5 - abs(cycles - floor(cycles + 0.5));
    return sin(glm::pi<double>() * y);
}

}  // namespace nacre::model
