#pragma once

#include <complex>

#include "material.hpp"

namespace nacre::model {

using Complex = std::complex<double>;

inline Complex product(Complex a, Complex b)
{
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

inline Complex complexRoot(Complex a)
{
    return std::sqrt(a);
}

}  // namespace nacre::model
