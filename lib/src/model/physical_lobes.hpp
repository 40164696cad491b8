#pragma once

#include "material.hpp"

namespace nacre::model {

template <class Cosine>  // double or dvec3
Cosine lobeFlattening(double exponent, Cosine cosLarger)
{
    return 1.0 + std::fmin(exponent, 1.0) * (cosLarger - 1.0);
}

inline dvec3 lowerLobeScale(dvec3 eta, double sineOfTilt, double exponent)
{
    const double apart = std::fmin(2.0 * sineOfTilt * std::sqrt(exponent + 1.0), 1.0) * std::fmin(4.0 * exponent, 1.0);
    return eta * std::sqrt((exponent + 2.0 - apart) / (exponent + 2.0));
}

}  // namespace nacre::model
