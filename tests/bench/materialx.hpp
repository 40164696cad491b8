#pragma once

#include <filesystem>

#include "candidate.hpp"

namespace nacre::bench {

/// MaterialX's own GLSL library, out of its Python package, fetched into the folder `peers` where it is
/// not there yet.
Result<Candidate> loadMaterialX(const std::filesystem::path& peers);

}  // namespace nacre::bench
