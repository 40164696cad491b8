#pragma once

#include <vector>

#include "inputs.hpp"
#include "random.hpp"

namespace nacre::test {

/// A part of the model's domain whose accuracy is stated apart.
struct Region {
    const char* name;
    const char* meaning;
    Input (*make)(Random& random);
};

const std::vector<Region>& regions();

}  // namespace nacre::test
