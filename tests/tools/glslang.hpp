#pragma once

#include <string>
#include <vector>

namespace nacre::test {

/// A fragment shader, and what names it in a failure.
struct NamedShader {
    std::string name, text;
};

/// What the Khronos reference compiler is asked.
enum class Glslang {
    opengl,  ///< Whether it takes the text, by the text's own #version.
    vulkan,  ///< Whether it takes it under Vulkan's rules.
    spirv,   ///< Whether it makes SPIR-V for Vulkan of it: as thorough as it gets, and slow.
};

/// The shaders that glslangValidator refuses, one text each: the name and its message. Many go to one process, two of
/// which run at a time; their files lie in a folder below the working directory that is deleted afterwards. A shader of
/// which the compiler says nothing counts as refused.
std::vector<std::string> refusedByGlslang(const std::vector<NamedShader>& shaders, Glslang target);

}  // namespace nacre::test
