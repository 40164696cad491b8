#pragma once

#include <functional>
#include <vector>

#include "inputs.hpp"

#include "random.hpp"

namespace nacre::test {

/// A part of the model's domain whose accuracy is stated apart.
struct Region {
    const char* name;
    const char* meaning;
    std::function<Input(Random& random)> make;
};

const std::vector<Region>& regions();

/// A layer of an index from the outside's to 3, exponents in [least, most] and the same thickness over wavelength in [leastCycles,
/// mostCycles], 2 r1 d / λ of the blue channel; any light, any tilt: what the bounds of the cheap forms are measured over.
Region formRegion(double leastExponent, double mostExponent, double leastCycles, double mostCycles);

}  // namespace nacre::test
