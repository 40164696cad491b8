#pragma once

#include "material.hpp"

namespace nacre::model {

inline double logOneMinus(double u)
{
    return std::log1p(-u);
}

inline double powerOneMinus(double u, double exponent)
{
    const double beyond = exponent > 0.0 ? 0.0 : 1.0;
    return u < 1.0 ? std::exp(exponent * logOneMinus(u)) : beyond;
}

inline dvec3 powerOneMinus(dvec3 u, double exponent)
{
    return {powerOneMinus(u.x, exponent), powerOneMinus(u.y, exponent), powerOneMinus(u.z, exponent)};
}

}  // namespace nacre::model
