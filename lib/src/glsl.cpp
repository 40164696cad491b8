#include <nacre/glsl.hpp>

namespace nacre {
namespace {

bool isSupported(const GlslOptions& options)
{
    const auto is = [&](int version) { return options.version == version; };
    return options.es ? is(300) || is(310) || is(320) : is(330) || (options.version >= 400 && options.version <= 460 && options.version % 10 == 0);
}

bool isWanted(const GlslFile& file, GlslUniforms uniforms)
{
    if (file.name == "nacre_uniform_block.glsl") return uniforms == GlslUniforms::block;
    if (file.name == "nacre_uniforms.glsl") return uniforms == GlslUniforms::plain;
    if (file.name == "nacre_material_from_uniforms.glsl") return uniforms != GlslUniforms::none;
    return true;
}

}  // namespace

Result<std::string> glsl(const GlslOptions& options)
{
    if (!isSupported(options)) {
        return Error{"nacre::glsl(): expected version 330, 400 to 460 in tens, or with es 300, 310, 320, got " +
                     std::to_string(options.version) + (options.es ? " es" : "")};
    }
    std::string text = "#version " + std::to_string(options.version) + (options.es ? " es\n" : " core\n");
    if (options.es) text += "precision highp float;\nprecision highp int;\n";

    int source = 0;
    for (const GlslFile& file : options.files ? *options.files : glslFiles()) {
        ++source;
        if (!isWanted(file, options.uniforms)) continue;
        text += "#line 1 " + std::to_string(source) + '\n';
        text += file.text;
    }
    return text + "#line 1 0\n";
}

}  // namespace nacre
