#pragma once

#include <vector>

#include <nacre/features.hpp>

namespace nacre::test {

/// Every shader that features can make of one material or a set, each once, canonical.
std::vector<Features> everyVariant();

/// The variant in a few words: `paper SD tilt…`, to name a failure.
std::string nameOf(const Features& features);

}  // namespace nacre::test
