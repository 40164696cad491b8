#pragma once

#include "material.hpp"

namespace nacre::model {

// Eq 7.
inline dvec3 reflectance(dvec3 normalReflectance, double cosTheta)
{
    const double m = 1.0 - cosTheta;
    const double m2 = m * m;
    return normalReflectance + (1.0 - normalReflectance) * (m2 * m2 * m);
}

// Eq 9 is (1 - f) times this.
template <class Cosine>  // double or dvec3
Cosine transmittanceShape(Cosine cosTheta)
{
    return cosTheta * (5.0 + cosTheta * (-10.0 + cosTheta * (10.0 + cosTheta * (-5.0 + cosTheta))));
}

inline dvec3 refractedCosineSquared(dvec3 etaSquared, dvec3 oneMinusEtaSquared, double cosTheta)
{
    return oneMinusEtaSquared + etaSquared * (cosTheta * cosTheta);
}

inline dvec3 refractedCosine(dvec3 cosSquared)
{
    return sqrt(max(cosSquared, 0.0));
}

}  // namespace nacre::model
