#pragma once

#include <filesystem>

#include "candidate.hpp"

namespace nacre::bench {

/// three.js's own GLSL, out of the npm package `three`, fetched into the folder `peers` where it is
/// not there yet.
Result<Candidate> loadThreeJs(const std::filesystem::path& peers);

}  // namespace nacre::bench
