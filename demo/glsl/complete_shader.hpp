#pragma once

#include <string>

#include <nacre/glsl.hpp>
#include <nacre/result.hpp>

namespace nacre::demo {

/// A whole fragment shader: nacre::glsl() with its lights, then the inputs and maps that the features ask for, and a
/// `main` that shades once per pixel and loops over the lights. For Vulkan the material's block is at binding 0 of
/// set 0, the lights' at 1, samplers from 2 on.
/// The uniforms must not be GlslUniforms::none.
Result<std::string> completeShader(GlslOptions options);

}  // namespace nacre::demo
