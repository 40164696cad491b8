#pragma once

#include <array>
#include <limits>

// What the cheap form of a part errs at most, over max(1, ρ), by the quantity that it depends on: twice the worst of
// 100,000 random cases of each range on llvmpipe, as nacre-accuracy --bounds prints it; features_test measures again.
namespace nacre::bounds {

struct Bound {
    double upTo;   ///< of the quantity
    double error;
};

// NACRE_STABLE_LOBES 0, by the greater exponent, from leastPlainExponent on; indices from the outside's on.
inline constexpr double leastPlainExponent = 2;  // below, a lobe rises too steeply from 0
inline constexpr std::array<Bound, 6> builtInLobes{{{3, 6e-6}, {30, 1.5e-5}, {100, 4e-5}, {300, 1e-4}, {1000, 4e-4}, {3000, 1.1e-3}}};

// NACRE_SPLIT_PHASE 0, by the greatest path through the layer, 2 r1 d / λ, in cycles.
inline constexpr std::array<Bound, 6> wholePhase{{{1, 5e-6}, {3, 5e-6}, {10, 1.4e-5}, {30, 4e-5}, {100, 1.4e-4}, {1000, 1.1e-3}}};

// NACRE_POLYNOMIAL_COSINE 0, by the same.
inline constexpr std::array<Bound, 2> builtInCosine{{{10, 6e-6}, {1000, 6e-4}}};

template <std::size_t Count>
constexpr double at(const std::array<Bound, Count>& bounds, double quantity)
{
    for (const Bound& bound : bounds) {
        if (quantity <= bound.upTo) return bound.error;
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace nacre::bounds
