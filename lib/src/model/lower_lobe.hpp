#pragma once

#include "material.hpp"

namespace nacre::model {

// Eq 10.
inline dvec3 lowerCosine(dvec3 eta, double cosBetween, double cosTheta, double cosNormal, dvec3 cosRefracted)
{
    return (eta * cosTheta - cosRefracted) * cosBetween - eta * cosNormal;
}

inline dvec3 lowerLobeOneMinus(dvec3 eta, dvec2 halfAcross, dvec2 upperAcross, double cosSum, dvec3 cosRefractedSum, dvec3 along)
{
    const dvec3 g = eta * cosSum - cosRefractedSum;
    const dvec3 x = g * upperAcross.x - eta * halfAcross.x;
    const dvec3 y = g * upperAcross.y - eta * halfAcross.y;
    return 0.5 * (x * x + y * y + along * along);
}

}  // namespace nacre::model
