#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "candidate.hpp"

namespace nacre::bench {

using Spirv = std::vector<std::uint32_t>;

enum class Stage { vertex, fragment };

/// GLSL 450 to SPIR-V for Vulkan, by glslangValidator (Debian: glslang-tools). names[i], a block or a
/// sampler, gets binding i of set 0. folder: where the files for and from the compiler go.
Result<Spirv> compileSpirv(const std::string& glsl, Stage stage, const std::vector<std::string>& names,
                           const std::filesystem::path& folder);

/// The names of what a candidate's fragment shader reads, in the order of their bindings: the frame,
/// the block if there is one, the tables.
std::vector<std::string> bindingNames(const Candidate& candidate);

}  // namespace nacre::bench
