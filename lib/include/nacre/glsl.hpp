#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nacre/features.hpp>
#include <nacre/result.hpp>

namespace nacre {

/// A file of the GLSL library, embedded: nothing is read at run time.
struct GlslFile {
    std::string_view name;  ///< `nacre_fresnel.glsl`
    std::string_view text;
};

/// All files, each after those that it needs.
const std::vector<GlslFile>& glslFiles();

/// How the material reaches the shader.
enum class GlslUniforms {
    none,   ///< Functions only: the host fills nacre_Material by its own means.
    block,  ///< A std140 block `nacre_Block`; see Block.
    plain,  ///< Plain uniforms; see Uniforms.
};

struct GlslOptions {
    int version = 330;  ///< 330 to 460; with es: 300 to 320; with vulkan: 450 or 460.
    bool es = false;
    GlslUniforms uniforms = GlslUniforms::block;
    Features features{};      ///< What the shader computes; the default is everything.
    bool isResolved = false;  ///< For readers and for engines without a preprocessor: no conditionals, no #line.
    bool vulkan = false;      ///< GLSL for Vulkan: the block is at `set = 0, binding = blockBinding`.
    int blockBinding = 0;
    bool lights = false;   ///< With nacre_lights.glsl and the block `nacre_Lights` for features.lights; see LightSource.
    int lightBinding = 1;  ///< Of that block for Vulkan.
    const std::vector<GlslFile>* files = nullptr;  ///< Other texts in place of glslFiles(), by the same names in the same order.
};

/// The library as one text for a shader, to be followed by the host's own declarations and `main`:
/// `#version`, precision for ES, the features' switches, then the functions that they leave. In a compiler's messages
/// source N is `glslFiles()[N - 1]`, source 0 is what the host appends.
/// Errors: a version that the library does not support, plain uniforms for Vulkan, more materials or lights than a
/// block holds.
Result<std::string> glsl(const GlslOptions& options = {});

/// The same without `#version` and precision, for a host that puts them itself: a chunk.
Result<std::string> glslChunk(const GlslOptions& options = {});

/// The `#define` lines that the features are.
std::string switches(const Features& features);

}  // namespace nacre
