#pragma once

#include <string>

#include "candidate.hpp"

namespace nacre::bench {

inline constexpr int maxLights = 64;  ///< The frame's uniform block has room for so many.

enum class Dialect {
    openGl,  ///< GLSL 330
    vulkan,  ///< GLSL 450; glslang gives the bindings
};

/// The vertex shader of one triangle that covers the picture.
std::string vertexShader(Dialect dialect);

/// Library, frame, candidate and main as one text.
///   straightLights  so many lights one after the other without a loop; 0: a loop over the block's count
Result<std::string> fragmentShader(const Candidate& candidate, Dialect dialect, int straightLights);

/// Library, frame, film.glsl, candidate, its bench_film and main as one text, GLSL 330: a film per pixel.
Result<std::string> filmShader(const Candidate& candidate);

}  // namespace nacre::bench
