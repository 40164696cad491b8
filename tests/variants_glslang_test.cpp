// Every combination of features through the Khronos reference compiler, for every version that the library is for.

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <cstdio>

#include <nacre/glsl.hpp>

#include "every_variant.hpp"
#include "glslang.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

struct Version {
    const char* name;
    int number;
    bool es, vulkan;
};

const Version versions[] = {{"330 core", 330, false, false}, {"410 core", 410, false, false}, {"450 core", 450, false, false},
                            {"300 es", 300, true, false},    {"310 es", 310, true, false},    {"450 Vulkan", 450, false, true}};

// Every other one without conditionals, which of them depends on the version: the two halves change places.
// Lights and blocks come and go the same way.
std::string textOf(const Features& features, const Version& version, std::size_t index)
{
    GlslOptions options{version.number, version.es, GlslUniforms::block, features};
    options.vulkan = version.vulkan;
    options.isResolved = index % 2 == 0;
    options.lights = index % 4 < 2;
    if (!version.vulkan && index % 3 == 0) options.uniforms = GlslUniforms::plain;
    const char* const output = version.vulkan ? "layout(location = 0) out vec4 colour;\n" : "out vec4 colour;\n";
    const char* const sampler = version.vulkan ? "layout(set = 0, binding = 2) uniform sampler2D fringeTable;\n" : "uniform sampler2D fringeTable;\n";
    return *glsl(options) + useOf(features, output, sampler);
}

class Variants : public testing::TestWithParam<std::size_t> {};

TEST_P(Variants, AreTakenByTheReferenceCompiler)
{
    const std::size_t which = GetParam();
    const Version& version = versions[which];
    const std::vector<Features> variants = everyVariant();
    const auto start = std::chrono::steady_clock::now();
    // With NACRE_EVERY_VARIANT set each variant is checked for each version; else each for two of the six, in turn. Sanitizers
    // see what assembles the text, not the compiler.
    const bool isEvery = std::getenv("NACRE_EVERY_VARIANT") != nullptr;
    const std::size_t stride = isEvery ? 1 : NACRE_SANITIZED ? 37 : 3;
    std::vector<NamedShader> shaders, some;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        if ((i + which) % stride != 0) continue;
        NamedShader shader{std::string(version.name) + ": " + nameOf(variants[i]), textOf(variants[i], version, i + which)};
        if (shaders.size() % 16 == 0) some.push_back(shader);
        shaders.push_back(std::move(shader));
    }
    for (const std::string& refused : refusedByGlslang(shaders, version.vulkan ? Glslang::vulkan : Glslang::opengl)) ADD_FAILURE() << refused;
    if (version.vulkan) {
        for (const std::string& refused : refusedByGlslang(some, Glslang::spirv)) ADD_FAILURE() << refused;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%zu of %zu variants as %s in %.1f s\n", shaders.size(), variants.size(), version.name, seconds.count());
    EXPECT_GT(shaders.size(), variants.size() / 60);
}

INSTANTIATE_TEST_SUITE_P(Versions, Variants, testing::Range<std::size_t>(0, std::size(versions)));

// A check that cannot fail would be none: one bad shader among good ones is found, and named, for each target.
TEST(Glslang, NamesTheShaderThatItRefuses)
{
    const Version& vulkan = versions[5];
    for (const Glslang target : {Glslang::opengl, Glslang::vulkan, Glslang::spirv}) {
        const Version& version = target == Glslang::opengl ? versions[0] : vulkan;
        std::vector<NamedShader> shaders;
        for (int i = 0; i < 5; ++i) shaders.push_back({"shader " + std::to_string(i), textOf(everyVariant()[0], version, 1)});
        EXPECT_TRUE(refusedByGlslang(shaders, target).empty());
        shaders[3].text += "float broken() { return vec3(1.0); }\n";
        const std::vector<std::string> refused = refusedByGlslang(shaders, target);
        ASSERT_GE(refused.size(), 1U);
        EXPECT_EQ(refused.front().substr(0, 9), "shader 3\n");
        EXPECT_NE(refused.front().find("cannot convert return value"), std::string::npos) << refused.front();
    }
    // What Vulkan alone forbids.
    const std::vector<NamedShader> plain{{"plain", "#version 450\nuniform float x;\nlayout(location = 0) out vec4 colour;\nvoid main() { colour = vec4(x); }\n"}};
    EXPECT_TRUE(refusedByGlslang(plain, Glslang::opengl).empty());
    EXPECT_EQ(refusedByGlslang(plain, Glslang::vulkan).size(), 1U);
}

// Source N of a message is glslFiles()[N - 1] and its line that file's own, whatever stands before.
TEST(Glslang, AMessageNamesTheFileAndItsLine)
{
    const std::vector<GlslFile>& files = glslFiles();
    for (std::size_t i = 1; i < files.size(); ++i) {
        GlslOptions options;
        options.lights = true;
        if (files[i].name == "nacre_uniforms.glsl") options.uniforms = GlslUniforms::plain;
        std::string text = *glsl(options);
        const std::string guard = std::string(files[i].text.substr(0, files[i].text.find('\n', files[i].text.find('\n') + 1) + 1));
        const std::size_t start = text.find(guard);
        ASSERT_NE(start, std::string::npos) << files[i].name;
        text.insert(start + guard.size(), "float nacre_broken() { return vec3(1.0); }\n");  // is line 3
        const std::vector<std::string> refused = refusedByGlslang({{"broken", text + "void main() {}\n"}}, Glslang::opengl);
        ASSERT_EQ(refused.size(), 1U) << files[i].name;
        EXPECT_NE(refused.front().find("ERROR: " + std::to_string(i + 1) + ":3: "), std::string::npos) << files[i].name << refused.front();
    }
    // And the host's own.
    const std::vector<std::string> refused = refusedByGlslang({{"broken", *glsl() + "\nvoid main() { vec3 x = 1; }\n"}}, Glslang::opengl);
    ASSERT_EQ(refused.size(), 1U);
    EXPECT_NE(refused.front().find("ERROR: 0:2: "), std::string::npos) << refused.front();
}

}  // namespace
