#pragma once

#include <array>
#include <limits>

// What the cheap form of a part errs at most, over max(1, ρ), by the quantity that it depends on. Made by
// nacre-accuracy --bounds; bounds_test measures them again.
namespace nacre::bounds {

struct Bound {
    double upTo;   ///< of the quantity
    double error;
};

// NACRE_STABLE_LOBES 0, by the greater exponent, from exponents of 1 on; indices from the outside's on.
inline constexpr std::array<Bound, 6> builtInLobes{{{3, 1e-5}, {30, 3e-5}, {100, 1e-4}, {300, 3e-4}, {1000, 1e-3}, {3000, 3e-3}}};

// NACRE_SPLIT_PHASE 0, by the greatest path through the layer, 2 r1 d / λ, in cycles.
inline constexpr std::array<Bound, 6> wholePhase{{{1, 1e-6}, {3, 3e-6}, {10, 1e-5}, {30, 3e-5}, {100, 1e-4}, {1000, 1e-3}}};

// NACRE_POLYNOMIAL_COSINE 0, by the same.
inline constexpr std::array<Bound, 1> builtInCosine{{{1000, 3e-6}}};

template <std::size_t Count>
constexpr double at(const std::array<Bound, Count>& bounds, double quantity)
{
    for (const Bound& bound : bounds) {
        if (quantity <= bound.upTo) return bound.error;
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace nacre::bounds
