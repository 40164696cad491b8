#pragma once

#include <string>

#include <nacre/result.hpp>

#include "functions.hpp"

namespace nacre::demo {

/// Compiles and links; the error holds the driver's log, in which a source number N means
/// glslFiles()[N - 1], replaced here by that file's name.
Result<GLuint> linkProgram(const GlFunctions& gl, const std::string& vertexSource, const std::string& fragmentSource);

}  // namespace nacre::demo
