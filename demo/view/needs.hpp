#pragma once

#include <string>
#include <vector>

#include <nacre/material.hpp>
#include <nacre/result.hpp>

namespace nacre::demo {

/// What a material asks of a shader: what the viewer's panel says, and the GLSL that has it.
struct Needs {
    std::vector<std::string> lines;
    std::string glsl;
};
Result<Needs> needsOf(const Material& material);

}  // namespace nacre::demo
