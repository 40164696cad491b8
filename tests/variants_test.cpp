// Every combination of features: compiles, links, and reads nothing that it has no use for.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
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
    const bool isEvery = std::getenv("NACRE_EVERY_VARIANT") != nullptr;
    std::size_t linked = 0, index = 0;
    for (const Features& features : variants) {
        // With NACRE_EVERY_VARIANT set all of them, else a third; sanitizers look for undefined behaviour, which fewer show as well.
        if (!isEvery && index++ % (NACRE_SANITIZED ? 20 : 3) != 0) continue;
        GlslOptions options;
        options.features = features;
        options.uniforms = GlslUniforms::plain;
        options.isResolved = true;
        const std::string text = *glsl(options) + useOf(features);
        const Result<GLuint> program = demo::linkProgram(context().gl(), vertexShader, text);
        ASSERT_TRUE(program) << nameOf(features) << '\n' << program.error().message;
        ASSERT_EQ(activeUniforms(*program), declaredUniforms(text)) << nameOf(features);
        context().gl().DeleteProgram(*program);
        ++linked;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%zu of %zu variants linked in %.1f s\n", linked, variants.size(), seconds.count());
    EXPECT_GT(linked, variants.size() / 30);
}

}  // namespace
