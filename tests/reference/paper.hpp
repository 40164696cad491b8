#pragma once

#include <array>

#include "vectors.hpp"

namespace nacre::test {

/// The paper's equations as they are printed (and read, see the README), in any precision: vectors are
/// refracted and reflected, powers are powers, nothing is rearranged. It shares no code with the library.
template <class Real>
struct Printed {
    using Vector = std::array<Real, 3>;
    using Rgb = std::array<Real, 3>;
    Rgb rho{}, R{}, T{}, phi{}, diffuse{};

    explicit Printed(const Case& one)
    {
        const Vector l = unit(one.light), v = unit(one.view), n0 = unit(one.surface.upperNormal), n1 = unit(one.surface.lowerNormal);
        for (int channel = 0; channel < 3; ++channel) evaluate(one, l, v, n0, n1, channel);
    }

private:
    void evaluate(const Case& one, const Vector& l, const Vector& v, const Vector& n0, const Vector& n1, int channel)
    {
        using std::acos;
        using std::cos;
        using std::pow;
        using std::sqrt;
        const auto k = static_cast<std::size_t>(channel);
        const Real r0 = one.material.iorOutside, r1 = one.material.ior[channel];
        const Real wavelength = one.material.wavelengthNm[channel], d = one.surface.thicknessNm;
        const Real pi = acos(Real(-1));

        const Real f = (r0 - r1) / (r0 + r1) * ((r0 - r1) / (r0 + r1));                       // Eq 8
        const Real Rd = (-38 * r0 * r1 + 21 * (r1 * r1 + r0 * r0)) / (21 * (r1 + r0) * (r1 + r0));  // Eq 12
        const Real Td = Real(80) / 21 * r0 * r1 / ((r1 + r0) * (r1 + r0));                    // Eq 13
        diffuse[k] = Rd + Td + 2 * cos(4 * pi * r1 * d / wavelength) * sqrt(Td * Rd);         // Eqs 11, 15, 16

        const Real ci = dot(n0, l), co = dot(n0, v);
        if (ci <= 0 || co <= 0) return;
        const Vector i = times(l, -1);
        Vector ti{}, to{};
        const bool lightEnters = refract(i, n0, r0 / r1, ti), viewEnters = refract(times(v, -1), n0, r0 / r1, to);
        const Real F = lightEnters ? schlick(f, ci) : Real(1);                                // Eq 7
        R[k] = F * lobe(dot(reflect(i, n0), v), one.material.upperExponent);                  // Eq 6
        rho[k] = R[k];
        if (!lightEnters || !viewEnters) return;
        phi[k] = pi * r1 * d / wavelength * -(dot(ti, n0) + dot(to, n0));                     // Eq 3

        const Real lower = -dot(reflect(ti, n1), to);
        if (dot(ti, n1) >= 0 || dot(to, n1) >= 0 || lower <= 0) return;                       // below Eq 10
        const Real transmitted = (1 - f) * (1 - pow(1 + dot(to, n0), 5));                     // Eq 9
        T[k] = (1 - F) * transmitted * lobe(lower, one.material.lowerExponent);               // Eq 10
        // As printed, F or 1 - F is below 0 by its rounding where it is 0, in any precision: the root would be NaN.
        const Real product = R[k] * T[k] > 0 ? R[k] * T[k] : Real(0);
        rho[k] = R[k] + T[k] + 2 * cos(2 * phi[k]) * sqrt(product);                           // Eq 5
    }

    static Real schlick(Real f, Real cosine)
    {
        using std::pow;
        return f + (1 - f) * pow(1 - cosine, 5);
    }

    static Real lobe(Real cosine, double exponent)
    {
        using std::pow;
        if (exponent == 0.0) return 1;
        return cosine > 0 ? pow(cosine, Real(exponent)) : Real(0);
    }

    static Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
    static Vector times(const Vector& a, Real factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }
    static Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
    static Vector reflect(const Vector& a, const Vector& n) { return plus(a, times(n, -2 * dot(a, n))); }

    static Vector unit(glm::dvec3 a)
    {
        using std::sqrt;
        const Vector wide{Real(a.x), Real(a.y), Real(a.z)};
        return times(wide, 1 / sqrt(dot(wide, wide)));
    }

    static bool refract(const Vector& a, const Vector& n, Real eta, Vector& refracted)
    {
        using std::sqrt;
        const Real cosine = -dot(a, n), squared = 1 - eta * eta * (1 - cosine * cosine);
        if (squared < 0) return false;
        refracted = plus(times(a, eta), times(n, eta * cosine - sqrt(squared)));
        return true;
    }
};

}  // namespace nacre::test
