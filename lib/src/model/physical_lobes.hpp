#pragma once

#include "material.hpp"

namespace nacre::model {

inline dvec3 lowerLobeOneMinusParallel(dvec3 etaSquared, double halfAcrossSquared, double cosThetaI, double cosThetaO, dvec3 cosRefractedSum)
{
    const double difference = (cosThetaI - cosThetaO) * (cosThetaI + cosThetaO);
    const dvec3 along = etaSquared * difference / max(cosRefractedSum, dvec3(1e-18));
    return 0.5 * (etaSquared * halfAcrossSquared + along * along);
}

template <class Cosine>  // double or dvec3
Cosine lobeFlattening(double exponent, Cosine cosLarger)
{
    return 1.0 + std::fmin(exponent, 1.0) * (cosLarger - 1.0);
}

inline dvec3 lowerLobeScale(dvec3 eta, dvec2 upperAcross, double exponent)
{
    const double apart = std::fmin(2.0 * length(upperAcross) * std::sqrt(exponent + 1.0), 1.0) * std::fmin(4.0 * exponent, 1.0);
    return eta * std::sqrt((exponent + 2.0 - apart) / (exponent + 2.0));
}

}  // namespace nacre::model
