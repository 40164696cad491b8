#pragma once

#include <string>
#include <vector>

#include <nacre/features.hpp>

namespace nacre::test {

/// Every shader that features can make of one material or a set, each once, canonical.
std::vector<Features> everyVariant();

/// The variant in a few words: `paper SD tilt…`, to name a failure.
std::string nameOf(const Features& features);

/// The declarations and the `main` that use all that a variant offers, behind its text by nacre::glsl with uniforms.
///   output   declaration of `colour`
///   sampler  declaration of `fringeTable`, for those who need it
std::string useOf(const Features& features, const std::string& output = "out vec4 colour;\n",
                  const std::string& sampler = "uniform sampler2D fringeTable;\n");

}  // namespace nacre::test
