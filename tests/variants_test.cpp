// Every combination of features: compiles, links, and reads nothing that it has no use for.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include <nacre/glsl.hpp>
#include <nacre/uniforms.hpp>

#include "every_variant.hpp"
#include "gl/program.hpp"
#include "gpu.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

const char* const vertexShader = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";

// All that a variant offers, used. stage: the inputs and the output with what the version asks of them.
std::string useOf(const Features& f, const std::string& sampler = "uniform sampler2D fringeTable;\n")
{
    const bool hasTable = f.fringes == Fringes::table;
    const std::string table = hasTable ? ", fringeTable" : "";
    std::string text = hasTable ? sampler : "";
    text += "void main()\n{\n    nacre_Material m = nacre_materialFromUniforms();\n    vec3 p = gl_FragCoord.xyz;\n";
    text += f.thickness == ThicknessSource::map ? "    nacre_Surface s = nacre_Surface(p, p.yzx, p.x);\n"
                                               : "    nacre_Surface s = nacre_surface(m, p, p.xyzx, p.zxy, mat3(1.0));\n";
    text += "    nacre_Shading w = nacre_shading(m, s, p.zxy" + table + ");\n    vec3 sum = vec3(0.0);\n";
    text += "    for (int i = 0; i < 2; ++i) sum += nacre_shade(m, w, p.yxz * float(i)" + table + ");\n";
    return text + "    colour = vec4(sum, 1.0);\n}\n";
}

std::set<std::string> declaredUniforms(const std::string& text)
{
    std::set<std::string> names;
    const std::regex declaration("\\nuniform \\w+ (\\w+);");
    for (std::sregex_iterator it(text.begin(), text.end(), declaration), end; it != end; ++it) names.insert((*it)[1]);
    return names;
}

std::set<std::string> activeUniforms(GLuint program)
{
    const demo::GlFunctions& gl = context().gl();
    std::set<std::string> names;
    GLint count = 0;
    gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char name[128];
        GLint size = 0;
        GLenum type = 0;
        gl.GetActiveUniform(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
        names.insert(name);
    }
    return names;
}

// The driver's compiler takes the plain uniforms that the shader does not need away: none may be among those declared.
TEST(Variants, LinkAndReadAllThatTheyDeclare)
{
    const std::vector<Features> variants = everyVariant();
    const auto start = std::chrono::steady_clock::now();
    std::size_t linked = 0;
    for (const Features& features : variants) {
        // Sanitizers look for undefined behaviour, which a seventh of the variants shows as well.
        if (NACRE_SANITIZED && key(features) % 7 != 0) continue;
        GlslOptions options;
        options.features = features;
        options.uniforms = GlslUniforms::plain;
        options.isResolved = true;
        const std::string text = *glsl(options) + "out vec4 colour;\n" + useOf(features);
        const Result<GLuint> program = demo::linkProgram(context().gl(), vertexShader, text);
        ASSERT_TRUE(program) << nameOf(features) << '\n' << program.error().message;
        ASSERT_EQ(activeUniforms(*program), declaredUniforms(text)) << nameOf(features);
        context().gl().DeleteProgram(*program);
        ++linked;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%zu of %zu variants linked in %.1f s\n", linked, variants.size(), seconds.count());
    EXPECT_GT(linked, variants.size() / 10);
}

}  // namespace
