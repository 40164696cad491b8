#include <nacre/glsl.hpp>

#include <algorithm>

#include <nacre/block.hpp>
#include <nacre/lights.hpp>

#include "glsl_conditionals.hpp"

namespace nacre {
namespace {

// 16 KiB, the least that OpenGL promises of a block.
constexpr int mostMaterials = 16384 / sizeof(Block);
constexpr int mostLights = (16384 - sizeof(LightHeader)) / sizeof(LightBlock);

bool isSupported(const GlslOptions& options)
{
    const auto is = [&](int version) { return options.version == version; };
    if (options.vulkan) return !options.es && (is(450) || is(460));
    return options.es ? is(300) || is(310) || is(320) : is(330) || (options.version >= 400 && options.version <= 460 && options.version % 10 == 0);
}

std::string faultOf(const GlslOptions& options)
{
    if (!isSupported(options)) {
        return "expected version 330, 400 to 460 in tens, with es 300, 310, 320, or with vulkan 450, 460, got " +
               std::to_string(options.version) + (options.es ? " es" : "") + (options.vulkan ? " for Vulkan" : "");
    }
    if (options.vulkan && options.uniforms == GlslUniforms::plain) return "expected a block or no uniforms for Vulkan, which has no plain ones";
    const int materials = options.features.materials;
    if (materials < 1 || materials > mostMaterials) {
        return "expected 1 to " + std::to_string(mostMaterials) + " materials in the block, got " + std::to_string(materials);
    }
    if (options.lights && options.features.lights > mostLights) {
        return "expected at most " + std::to_string(mostLights) + " lights in the block, got " + std::to_string(options.features.lights);
    }
    return {};
}

bool isWanted(const GlslFile& file, const GlslOptions& options)
{
    const GlslUniforms uniforms = options.uniforms;
    if (file.name == "nacre_lights.glsl" || file.name == "nacre_light_block.glsl") return options.lights;
    if (file.name == "nacre_uniform_block.glsl") return uniforms == GlslUniforms::block;
    if (file.name == "nacre_uniforms.glsl") return uniforms == GlslUniforms::plain;
    if (file.name == "nacre_material_from_uniforms.glsl") return uniforms != GlslUniforms::none;
    return true;
}

std::string vulkanLayout(const char* macro, int binding)
{
    return std::string("#define ") + macro + " layout(std140, set = 0, binding = " + std::to_string(binding) + ")\n";
}

// What precedes the functions: switches, and where Vulkan has the blocks.
std::string defines(const GlslOptions& options)
{
    std::string text = switches(options.features);
    if (options.vulkan && options.uniforms == GlslUniforms::block) text += vulkanLayout("NACRE_BLOCK_LAYOUT", options.blockBinding);
    if (options.vulkan && options.lights) text += vulkanLayout("NACRE_LIGHT_LAYOUT", options.lightBinding);
    return text;
}

// The switches without what they mean, which is for those who set them.
std::string withoutComments(std::string_view text)
{
    std::string lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        if (text.front() == '#') lines += text.substr(0, end);
        text.remove_prefix(end);
    }
    return lines;
}

std::string functions(const GlslOptions& options)
{
    const std::vector<GlslFile>& files = options.files ? *options.files : glslFiles();
    const std::string before = defines(options), config = files.empty() ? "" : withoutComments(files.front().text);
    std::vector<std::string_view> resolved{before, config};
    std::string text = before;
    int source = 0;
    for (const GlslFile& file : files) {
        ++source;
        if (!isWanted(file, options)) continue;
        if (source > 1) resolved.push_back(file.text);
        text += "#line 1 " + std::to_string(source) + '\n';
        text += file.text;
    }
    return options.isResolved ? withoutConditionals(resolved) : text + "#line 1 0\n";
}

}  // namespace

std::string switches(const Features& features)
{
    const Features f = canonical(features);
    std::string text;
    const auto define = [&](const char* name, int value) { text += std::string("#define ") + name + ' ' + std::to_string(value) + '\n'; };
    define("NACRE_PAPER", f.paper);
    define("NACRE_PHYSICAL", f.physical);
    define("NACRE_SPECULAR", f.specular);
    define("NACRE_DIFFUSE", f.diffuse);
    define("NACRE_DISPERSION", f.dispersion);
    define("NACRE_TILT", f.lowerNormals != LowerNormals::parallel);
    define("NACRE_TOTAL_REFLECTION", f.totalReflection);
    define("NACRE_THICKNESS", static_cast<int>(f.thickness));
    // The host's own normals need no code.
    define("NACRE_LOWER_NORMAL", f.thickness == ThicknessSource::map ? 0 : static_cast<int>(f.lowerNormals));
    define("NACRE_SUBSTRATE_CHANNELS", f.substrateChannels);
    define("NACRE_METAL", f.metal);
    define("NACRE_NORMALISED", f.normalised);
    define("NACRE_FRINGE_TABLE", f.fringes != Fringes::samplerFree);
    define("NACRE_SAMPLER_FREE", f.fringes != Fringes::table);
    define("NACRE_STABLE_LOBES", f.stableLobes);
    define("NACRE_SPLIT_PHASE", f.splitPhase);
    define("NACRE_POLYNOMIAL_COSINE", f.polynomialCosine);
    define("NACRE_MATERIALS", f.materials);
    define("NACRE_MAX_LIGHTS", f.lights);
    return text;
}

Result<std::string> glslChunk(const GlslOptions& options)
{
    if (const std::string fault = faultOf(options); !fault.empty()) return Error{"nacre::glsl(): " + fault};
    return functions(options);
}

Result<std::string> glsl(const GlslOptions& options)
{
    Result<std::string> chunk = glslChunk(options);
    if (!chunk) return chunk;
    std::string text = "#version " + std::to_string(options.version) + (options.es ? " es\n" : " core\n");
    if (options.es) text += "precision highp float;\nprecision highp int;\n";
    return text + *chunk;
}

}  // namespace nacre
