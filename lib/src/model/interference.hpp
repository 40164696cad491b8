#pragma once

#include "material.hpp"

namespace nacre::model {

// Eq 5.
inline dvec3 interference(dvec3 sqrtR, dvec3 sqrtT, dvec3 cosPhase)
{
    const dvec3 difference = sqrtR - sqrtT;
    return difference * difference + 4.0 * sqrtR * sqrtT * (cosPhase * cosPhase);
}

}  // namespace nacre::model
