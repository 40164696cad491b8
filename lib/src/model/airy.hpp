#pragma once

#include <array>

#include "boundary.hpp"

namespace nacre::model {

struct Film {
    double upper;
    double lower;
    dvec2 fringe;
    ComplexPair ratio;
};

inline Film film(dvec2 a, dvec2 bSquared, ComplexPair ratio, dvec2 crossing)
{
    Film film;
    // 1e-14: the rounding of 1 - |q|² in double precision.
    const dvec2 lower = crossing * crossing * bSquared / max(1.0 - a * a * bSquared, dvec2(1e-14));
    film.upper = 0.5 * dot(a, a);
    film.lower = 0.5 * (lower.x + lower.y);
    film.fringe = lower - crossing;
    film.ratio = ratio;
    return film;
}

template <std::size_t Orders>
double fringeSum(const Film& film, const std::array<double, Orders>& c, double coherence)
{
    const dvec2 q(film.ratio.s.real(), film.ratio.p.real());
    dvec2 power = film.fringe;
    double sum = 0.0, last = 1.0, previous = 1.0;
    for (std::size_t m = 0; m < Orders; ++m) {
        power *= q;
        sum += (power.x + power.y) * c[m];
        previous = last;
        last = c[m];
    }
    power *= q;
    const double fade = std::pow(coherence, 2.0 / static_cast<double>(Orders));
    const double next = fade * (2.0 * c[0] * last - fade * previous);
    const double r = q.x * fade;
    const double whole = 1.0 - std::fabs(q.x);
    const double tail = (next - r * last) / std::fmax(1.0 - 2.0 * r * c[0] + r * r, std::fmax(whole * whole, 1e-6));
    return sum + (power.x + power.y) * tail;
}

inline double fringeTail(Complex next, Complex ratio, double largest)
{
    const Complex d = 1.0 - ratio;
    const double whole = 1.0 - largest;
    return (next.real() * d.real() + next.imag() * d.imag()) / std::fmax(std::norm(d), std::fmax(whole * whole, 1e-6));
}

template <std::size_t Orders>
double fringeSumMetal(const Film& film, const std::array<Complex, Orders>& c, double coherence)
{
    const Complex qs = film.ratio.s, qp = film.ratio.p;
    Complex powerS = film.fringe.x, powerP = film.fringe.y;
    Complex last = 1.0;
    double sum = 0.0;
    for (std::size_t m = 0; m < Orders; ++m) {
        powerS = product(powerS, qs);
        powerP = product(powerP, qp);
        sum += product(powerS + powerP, c[m]).real();
        last = c[m];
    }
    const double fade = std::pow(coherence, 2.0 / static_cast<double>(Orders));
    const Complex fadedFirst = fade * c[0];
    const Complex next = product(fadedFirst, last);
    const Complex nextS = product(product(powerS, qs), next);
    const Complex nextP = product(product(powerP, qp), next);
    return sum + fringeTail(nextS, product(qs, fadedFirst), std::abs(qs)) + fringeTail(nextP, product(qp, fadedFirst), std::abs(qp));
}

inline double filmReflectance(const Film& film, double fringes, double rootUpper, double rootLower)
{
    const double bounded = std::fmin(fringes, 1.0 - film.upper - film.lower);
    return std::fmax(film.upper * rootUpper * rootUpper + film.lower * rootLower * rootLower + bounded * rootUpper * rootLower, 0.0);
}

}  // namespace nacre::model
