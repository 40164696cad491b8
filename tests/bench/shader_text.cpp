#include "shader_text.hpp"

#include <nacre/glsl.hpp>

#include "naive_forms.hpp"
#include "text_file.hpp"

namespace nacre::bench {
namespace {

int version(Dialect dialect)
{
    return dialect == Dialect::openGl ? 330 : 450;
}

std::string addLight(const std::string& index)
{
    return "sum += bench_light(p, w, bench_toLight(p, " + index + "));\n";
}

// Library and frame, then what follows them.
Result<std::string> withLibrary(const Candidate& candidate, Dialect dialect, const std::string& rest)
{
    std::string text = "#version " + std::to_string(version(dialect)) + " core\n";
    if (candidate.usesLibrary) {
        const GlslUniforms uniforms = candidate.blockName == "nacre_Block" ? GlslUniforms::block : GlslUniforms::none;
        Result<std::string> library = glsl({version(dialect), false, uniforms, candidate.features});
        if (!library) return library;
        if (!candidate.naiveForm.empty()) library = test::withNaiveForm(*library, candidate.naiveForm);
        if (!library) return library;
        text = *library;
    }
    Result<std::string> frame = readGlsl("frame.glsl");
    if (!frame) return frame;
    return text + "#define BENCH_MAX_LIGHTS " + std::to_string(maxLights) + '\n' + *frame + rest;
}

}  // namespace

std::string vertexShader(Dialect dialect)
{
    const std::string index = dialect == Dialect::openGl ? "gl_VertexID" : "gl_VertexIndex";
    return "#version " + std::to_string(version(dialect)) + " core\nvoid main()\n{\n    gl_Position = vec4(vec2(" + index + " & 1, " +
           index + " >> 1) * 4.0 - 1.0, 0.0, 1.0);\n}\n";
}

Result<std::string> fragmentShader(const Candidate& candidate, Dialect dialect, int straightLights)
{
    std::string main = "layout(location = 0) out vec4 bench_color;\nvoid main()\n{\n"
                       "bench_Point p = bench_point();\nbench_View w = bench_view(p);\nvec3 sum = vec3(0.0);\n";
    for (int light = 0; light < straightLights; ++light) main += addLight(std::to_string(light));
    if (straightLights == 0) main += "for (int i = 0; i < bench_lightCount; ++i) " + addLight("i");
    return withLibrary(candidate, dialect, candidate.glsl + main + "bench_color = vec4(sum, bench_inputs(p));\n}\n");
}

Result<std::string> filmShader(const Candidate& candidate)
{
    Result<std::string> film = readGlsl("film.glsl");
    if (!film) return film;
    return withLibrary(candidate, Dialect::openGl,
                       *film + candidate.glsl + candidate.film.glsl +
                           "layout(location = 0) out vec4 bench_color;\nvoid main()\n{\n"
                           "bench_color = vec4(bench_film(bench_filmOfPixel()), 1.0);\n}\n");
}

}  // namespace nacre::bench
