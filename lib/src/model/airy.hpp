#pragma once

#include <array>

#include "boundary.hpp"
#include "fringe.hpp"
#include "fringe_table.hpp"

namespace nacre::model {

struct Film {
    double upper;
    double lower;
    dvec2 fringe;
    dvec2 inverse;
    ComplexPair ratio;
};

inline void weigh(Film& film, dvec2 aSquared, dvec2 bSquared, dvec2 crossing)
{
    // 1e-14: the rounding of 1 - |q|² in double precision.
    film.inverse = 1.0 / max(1.0 - aSquared * bSquared, dvec2(1e-14));
    const dvec2 lower = crossing * crossing * bSquared * film.inverse;
    film.upper = 0.5 * (aSquared.x + aSquared.y);
    film.lower = 0.5 * (lower.x + lower.y);
    film.fringe = lower - crossing;
}

inline dvec3 filmReflectance(const Film& film, dvec3 fringes, double rootUpper, double rootLower)
{
    const dvec3 bounded = min(fringes, dvec3(1.1 - film.upper - film.lower));
    return max(film.upper * rootUpper * rootUpper + film.lower * rootLower * rootLower + bounded * (rootUpper * rootLower), dvec3(0.0));
}

// The fringes from the table.
inline dvec3 fringeSum(const FringeTable& table, const Film& film, double path, double pathPerRadian)
{
    const dvec2 weight = film.fringe * film.inverse;
    return weight.x * fringeOfRatio(table, path, film.ratio.s, pathPerRadian) + weight.y * fringeOfRatio(table, path, film.ratio.p, pathPerRadian);
}

template <std::size_t Orders>
double fade(double coherence)
{
    return std::pow(coherence, 2.0 / static_cast<double>(Orders));
}

template <std::size_t Orders>
dvec3 fringeSum(const Film& film, const Fringe<Orders>& c)
{
    const dvec2 q(film.ratio.s.real(), film.ratio.p.real());
    dvec2 power = film.fringe;
    dvec3 sum(0.0), last(1.0), previous(1.0);
    for (std::size_t m = 0; m < Orders; ++m) {
        power *= q;
        sum += (power.x + power.y) * c.order[m];
        previous = last;
        last = c.order[m];
    }
    power *= q;
    const double faded = fade<Orders>(c.coherence);
    const dvec3 next = faded * (2.0 * c.order[0] * last - faded * previous);
    const double r = q.x * faded;
    const double whole = 1.0 - std::fabs(q.x);
    const dvec3 tail = (next - r * last) / max(1.0 - 2.0 * r * c.order[0] + r * r, dvec3(std::fmax(whole * whole, 1e-6)));
    return sum + (power.x + power.y) * tail;
}

inline double fringeTail(Complex next, Complex ratio, double largest)
{
    const Complex d = 1.0 - ratio;
    const double whole = 1.0 - largest;
    return (next.real() * d.real() + next.imag() * d.imag()) / std::fmax(std::norm(d), std::fmax(whole * whole, 1e-6));
}

template <std::size_t Orders>
double fringeSumMetal(const Film& film, const Fringe<Orders>& cosine, const Fringe<Orders>& sine, int channel)
{
    const Complex qs = film.ratio.s, qp = film.ratio.p;
    Complex powerS = film.fringe.x, powerP = film.fringe.y;
    Complex last = 1.0;
    double sum = 0.0;
    for (std::size_t m = 0; m < Orders; ++m) {
        powerS = product(powerS, qs);
        powerP = product(powerP, qp);
        last = Complex(cosine.order[m][channel], sine.order[m][channel]);
        sum += product(powerS + powerP, last).real();
    }
    const Complex fadedFirst = fade<Orders>(cosine.coherence) * Complex(cosine.order[0][channel], sine.order[0][channel]);
    const Complex next = product(fadedFirst, last);
    const Complex nextS = product(product(powerS, qs), next);
    const Complex nextP = product(product(powerP, qp), next);
    return sum + fringeTail(nextS, product(qs, fadedFirst), std::abs(qs)) + fringeTail(nextP, product(qp, fadedFirst), std::abs(qp));
}

}  // namespace nacre::model
