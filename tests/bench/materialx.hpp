#pragma once

#include <filesystem>

#include "candidate.hpp"

namespace nacre::bench {

/// MaterialX's own GLSL library, out of its Python package, fetched into the folder `peers` where it is
/// not there yet: dielectric_bsdf with a thin film alone, and standard_surface's mix of conductor_bsdf and
/// dielectric_bsdf, both with the film, over a diffuse base.
Result<Candidate> loadMaterialXDielectric(const std::filesystem::path& peers);
Result<Candidate> loadMaterialXSurface(const std::filesystem::path& peers);

}  // namespace nacre::bench
