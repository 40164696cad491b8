#pragma once

#include <cfloat>

#include "material.hpp"

namespace nacre::model {

// Eq 12.
inline dvec3 diffuseReflectance(dvec3 normalReflectance)
{
    return (20.0 * normalReflectance + 1.0) / 21.0;
}

// Eq 13.
inline dvec3 diffuseTransmittance(dvec3 normalReflectance)
{
    return (20.0 / 21.0) * (1.0 - normalReflectance);
}

// Eq 14.
inline dvec3 meanRefractedCosine(dvec3 eta, dvec3 oneMinusEtaSquared, dvec3 normalReflectance)
{
    const dvec3 logarithm = -0.5 * log(max(normalReflectance, dvec3(DBL_MIN)));
    const dvec3 mean = 0.5 + 0.25 * logarithm * oneMinusEtaSquared / eta;
    return mix(mean, dvec3(0.0), lessThan(oneMinusEtaSquared, dvec3(0.0)));
}

// Eq 16.
inline dvec3 diffuseCoefficient(dvec3 diffuseFringe, dvec3 cosPhase)
{
    return (1.0 - diffuseFringe) + 2.0 * diffuseFringe * (cosPhase * cosPhase);
}

}  // namespace nacre::model
