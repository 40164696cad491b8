#pragma once

#include "complex.hpp"

namespace nacre::model {

inline dvec2 inverses(dvec2 a)
{
    return dvec2(a.y, a.x) / std::fmax(a.x * a.y, 1e-30);
}

inline dvec2 upperAmplitudes(double eta, double oneMinusEtaSquared, double cosTheta, double cosRefracted)
{
    const dvec2 inverse = inverses(dvec2(eta * cosTheta + cosRefracted, cosTheta + eta * cosRefracted));
    const double etaSquared = eta * eta;
    const double p = cosTheta * cosTheta * (1.0 + etaSquared) - etaSquared;
    return oneMinusEtaSquared * dvec2(-1.0, p) * (inverse * inverse);
}

inline dvec2 crossing(double eta, double cosTheta, double cosRefracted)
{
    const double root = 2.0 * std::sqrt(eta * cosTheta * cosRefracted);
    return root * inverses(dvec2(eta * cosTheta + cosRefracted, cosTheta + eta * cosRefracted));
}

inline dvec2 lowerAmplitudes(double substrate, double sineSquared, double cosRefracted)
{
    const double w = std::sqrt(std::fmax(substrate - sineSquared, 0.0));
    const dvec2 g = dvec2(1.0, substrate) * cosRefracted;
    return (g - w) * inverses(g + w);
}

struct ComplexPair {
    Complex s, p;
};

inline ComplexPair lowerAmplitudesMetal(Complex substrate, double sineSquared, double cosRefracted)
{
    const double real = substrate.real() - sineSquared;
    const Complex w = complexRoot({substrate.imag() > 0.0 ? real : std::fmax(real, 0.0), substrate.imag()});
    const double w2 = std::norm(w);
    const double g = cosRefracted;
    const Complex s = Complex(g * g - w2, -2.0 * g * w.imag()) / std::fmax(std::norm(g + w), 1e-18);
    const Complex below = g * substrate + w;
    const Complex p(std::norm(substrate) * (g * g) - w2, 2.0 * g * (substrate.imag() * w.real() - substrate.real() * w.imag()));
    return {s, p / std::fmax(std::norm(below), 1e-18)};
}

}  // namespace nacre::model
