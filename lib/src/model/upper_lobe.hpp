#pragma once

#include "material.hpp"

namespace nacre::model {

// Eq 6.
inline double upperLobeOneMinus(dvec3 upperNormal, dvec3 halfVector, double cosThetaI, double cosThetaO)
{
    const dvec3 across = halfVector - upperNormal * (cosThetaI + cosThetaO);
    const double along = cosThetaI - cosThetaO;
    return 0.5 * (dot(across, across) + along * along);
}

}  // namespace nacre::model
