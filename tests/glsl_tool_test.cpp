// nacre-glsl as a user meets it: what it prints, that compilers take it, and what it says to bad input.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include <nacre/feature_names.hpp>
#include <nacre/glsl.hpp>
#include <nacre/presets.hpp>

#include "every_variant.hpp"
#include "glslang.hpp"
#include "process.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

Finished tool(const std::string& arguments)
{
    return run(NACRE_GLSL " " + arguments);
}

std::string textOf(const std::string& arguments)
{
    const Finished finished = tool(arguments);
    EXPECT_EQ(finished.status, 0) << arguments << '\n' << finished.output;
    return finished.output;
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

const char* const versions[] = {"330", "400", "410", "420", "430", "440", "450", "460", "300 es", "310 es", "320 es", "450 vulkan", "460 vulkan"};

// What a host puts around a chunk.
std::string wrapped(const std::string& chunk, const std::string& version)
{
    const bool isEs = contains(version, "es"), isVulkan = contains(version, "vulkan");
    return "#version " + (isEs ? version : version.substr(0, 3)) + '\n' + (isEs ? "precision highp float;\nprecision highp int;\n" : "") + chunk +
           (isVulkan || isEs ? "layout(location = 0) " : "") +
           "out vec4 colour;\nvoid main() { colour = vec4(nacre_shade(nacre_materialFromUniforms(),\n"
           "nacre_shading(nacre_materialFromUniforms(), nacre_Surface(vec3(1.0), vec3(1.0), 1.0), vec3(1.0)), vec3(1.0)), 1.0); }\n";
}

// What stands at global scope or is defined without the library's prefix.
std::set<std::string> unprefixed(const std::string& text)
{
    const std::string code = std::regex_replace(text, std::regex("//[^\n]*"), "");
    int depth = 0;
    std::string outer;  // without what is in braces
    for (const char c : code) {
        depth -= c == '}';
        if (depth == 0) outer += c;
        depth += c == '{';
    }
    const std::regex declared(R"((?:^|\n)(?:#define (\w+)|(?:layout\([^)]*\) |flat |highp |uniform |in |out |struct |const )*(?:\w+ )?(\w+) ?[({;\[=]))");
    std::set<std::string> names;
    int count = 0;
    for (std::sregex_iterator it(outer.begin(), outer.end(), declared), end; it != end; ++it, ++count) {
        const std::string word = (*it)[1].matched ? (*it)[1] : (*it)[2];
        const bool isPrecision = word == "float" || word == "int";
        if (!isPrecision && word.rfind("nacre_", 0) != 0 && word.rfind("NACRE_", 0) != 0) names.insert(word);
    }
    EXPECT_GT(count, 20);
    return names;
}

TEST(GlslTool, EveryPresetCompilesInEveryVersion)
{
    std::vector<NamedShader> opengl, vulkan;
    for (const Preset& preset : presets()) {
        for (const std::string version : versions) {
            const std::string arguments = "--preset " + std::string(preset.name) + " --version '" + version + "'";
            auto& shaders = contains(version, "vulkan") ? vulkan : opengl;
            shaders.push_back({arguments, wrapped(textOf(arguments), version)});
            shaders.push_back({arguments + " --complete", textOf(arguments + " --complete")});
        }
    }
    for (const std::string& refused : refusedByGlslang(opengl, Glslang::opengl)) ADD_FAILURE() << refused;
    for (const std::string& refused : refusedByGlslang(vulkan, Glslang::spirv)) ADD_FAILURE() << refused;
    EXPECT_EQ(opengl.size() + vulkan.size(), 9U * 13U * 2U);
}

// Inputs, maps and samplers come with features that no preset has.
TEST(GlslTool, WholeShadersForEveryKindOfFeature)
{
    const char* const features[] = {
        "paper,specular", "paper,physical,specular,diffuse,noise,tilt,fringe-table", "physical,specular,fringe-table,constant-tilt",
        "physical,specular,diffuse,either-fringes,independent-tilt", "paper,specular,thickness-map", "physical,specular,diffuse,thickness-map,tilt,metal,fringe-table",
        "paper,diffuse", "paper,specular,gradient-tilt,dispersion,stable-lobes,split-phase,polynomial-cosine"};
    std::vector<NamedShader> opengl, vulkan;
    for (const std::string list : features) {
        for (const std::string version : {"330", "410", "300 es", "310 es", "450 vulkan"}) {
            for (const std::string more : {"", " --with-conditionals", " --uniforms plain", " --materials 3 --lights 64"}) {
                const bool isVulkan = contains(version, "vulkan");
                if (isVulkan && contains(more, "plain")) continue;
                const std::string arguments = "--complete --features " + list + " --version '" + version + "'" + more;
                (isVulkan ? vulkan : opengl).push_back({arguments, textOf(arguments)});
            }
        }
    }
    for (const std::string& refused : refusedByGlslang(opengl, Glslang::opengl)) ADD_FAILURE() << refused;
    for (const std::string& refused : refusedByGlslang(vulkan, Glslang::spirv)) ADD_FAILURE() << refused;
}

TEST(GlslTool, TextIsTheVariantsOwn)
{
    const std::string chunk = textOf("--preset figure-3-right");
    EXPECT_EQ(chunk.rfind("// nacre ", 0), 0U);
    EXPECT_TRUE(contains(chunk, "MIT License"));
    EXPECT_TRUE(contains(chunk, "--features " + namesOf(*featuresOf(*preset("figure-3-right"))) + '\n'));
    for (const char* absent : {"#if", "#else", "#endif", "#line", "#version", "#extension", "precision ", "main(", "nacre_physicalLight", "nacre_Lights"}) {
        EXPECT_FALSE(contains(chunk, absent)) << absent;
    }
    EXPECT_TRUE(contains(textOf("--preset figure-3-right --lights 7"), "NACRE_MAX_LIGHTS 7\n"));
    EXPECT_TRUE(contains(textOf("--preset figure-3-right --with-conditionals"), "#line 1 1\n"));
    EXPECT_FALSE(contains(textOf("--uniforms none"), "uniform "));
    EXPECT_TRUE(contains(textOf("--uniforms plain"), "uniform vec3 nacre_u_"));
    EXPECT_TRUE(contains(textOf("--materials 5"), "#define NACRE_MATERIALS 5\n"));
    EXPECT_TRUE(contains(textOf("--quality physical"), "nacre_physicalLight"));
    EXPECT_TRUE(contains(textOf("--quality physical"), "sampler2D"));
    EXPECT_FALSE(contains(textOf("--quality physical --fringes sampler-free"), "sampler2D"));
    EXPECT_TRUE(contains(textOf("--machine cpu"), "polynomial-cosine"));
    EXPECT_TRUE(contains(textOf("--error 0"), "stable-lobes"));
    EXPECT_TRUE(contains(textOf("--thickness-map --lower-normal-map"), "thickness-map,tilt"));
    EXPECT_EQ(textOf("--complete --version '300 es'").rfind("#version 300 es\n// nacre ", 0), 0U);
}

TEST(GlslTool, NamesBearThePrefix)
{
    const std::set<std::string> onlyMain{"main"};
    EXPECT_EQ(unprefixed(textOf("--preset figure-3-right --complete")), onlyMain);
    EXPECT_EQ(unprefixed(textOf("--preset figure-4 --version '450 vulkan' --complete --materials 2")), onlyMain);
    EXPECT_EQ(unprefixed(textOf("--features paper,physical,specular,diffuse,thickness-map,tilt,fringe-table --version '300 es' --complete")), onlyMain);
    const std::set<std::string> caught{"A", "b", "c", "D", "e", "f", "g"};
    EXPECT_EQ(unprefixed(textOf("--preset figure-4") + "#define A 1\nfloat b(vec3 x)\n{\n}\nuniform vec3 c;\nstruct D {\n};\nlayout(location = 0) in vec3 e;\n"
                                                       "uniform highp sampler2D f;\nconst float g = 1.0;\n"),
              caught);
}

TEST(GlslTool, ListNamesPresetsAndFeatures)
{
    const std::string list = textOf("--list");
    for (const Preset& preset : presets()) EXPECT_TRUE(contains(list, "  " + std::string(preset.name) + ' '));
    for (const FeatureName& feature : featureNames()) EXPECT_TRUE(contains(list, "  " + std::string(feature.name) + ' '));
}

// Every variant has a list, and it is its own.
TEST(FeatureNames, GiveBackTheFeatures)
{
    std::set<std::string> lists;
    for (const Features& features : everyVariant()) {
        const std::string list = namesOf(features);
        lists.insert(list);
        Result<Features> back = featuresFromNames(list);
        ASSERT_TRUE(back) << back.error().message;
        back->lights = features.lights;
        EXPECT_EQ(*back, features) << list;
    }
    EXPECT_EQ(lists.size(), everyVariant().size());
    Features either;
    EXPECT_EQ(*featuresFromNames(namesOf(either)), either);
    EXPECT_EQ(featuresFromNames("paper,tilt,constant-tilt").error().message,
              "nacre::featuresFromNames(): 'tilt' and another of 'paper,tilt,constant-tilt' exclude each other");
    EXPECT_EQ(featuresFromNames("paper,").error().message.substr(0, 62), "nacre::featuresFromNames(): no feature '', there are paper, ph");
}

// One line, status 2, nothing written.
void expectRefusal(const std::string& arguments, const std::string& expected)
{
    const Finished finished = tool(arguments);
    EXPECT_EQ(finished.status, 2) << arguments;
    EXPECT_EQ(finished.output, "nacre-glsl: " + expected + '\n') << arguments;
}

TEST(GlslTool, RefusesBadInput)
{
    expectRefusal("--preset nowhere", "--preset: no preset 'nowhere', there are figure-2-left, figure-2-centre, figure-2-right, figure-3-left, "
                                      "figure-3-right, figure-4, figure-5-left, figure-5-centre, figure-5-right");
    expectRefusal("--version 120", "--version: expected version 330, 400 to 460 in tens, with es 300, 310, 320, or with vulkan 450, 460, got 120");
    expectRefusal("--version es", "--version: expected a version like 330, '300 es' or '450 vulkan', got 'es'");
    expectRefusal("--version '330 compatibility'", "--version: expected a version like 330, '300 es' or '450 vulkan', got '330 compatibility'");
    expectRefusal("--version ''", "--version: expected a version like 330, '300 es' or '450 vulkan', got ''");
    expectRefusal("--version '330 vulkan'", "--version: expected version 330, 400 to 460 in tens, with es 300, 310, 320, or with vulkan 450, 460, got 330 for Vulkan");
    expectRefusal("--uniforms plain --version '450 vulkan'", "--uniforms: expected a block or no uniforms for Vulkan, which has no plain ones");
    expectRefusal("--uniforms none --complete", "--uniforms: expected block or plain with --complete, got none: a whole shader needs its material");
    expectRefusal("--uniforms plain --materials 2", "--materials: expected 1 with --uniforms plain, got 2");
    expectRefusal("--materials 65", "--materials: expected 1 to 64 materials in the block, got 65");
    expectRefusal("--materials 0", "--materials: expected 1 to 64 materials in the block, got 0");
    expectRefusal("--lights 0", "--lights: expected 1 or more, got 0");
    expectRefusal("--lights 256", "--lights: expected at most 255 lights in the block, got 256");
    expectRefusal("--error -1", "--error: expected error >= 0, got -1.000000");
    expectRefusal("--ior -1", "--ior: expected 0.1 <= ior.r <= 10, got -1");
    expectRefusal("--features paper --ior 1.4", "--features: expected no material beside the list of its features");
    expectRefusal("--features paper,noise,thickness-map", "--features: 'noise' and another of 'paper,noise,thickness-map' exclude each other");
    expectRefusal("--out /nowhere/x.glsl", "--out: cannot write '/nowhere/x.glsl': there is no directory '/nowhere'");
    expectRefusal("--out /dev/null", "--out: cannot write '/dev/null': it is a device or a pipe");
    const auto expectOneLine = [](const std::string& arguments, const std::string& part) {
        const Finished finished = tool(arguments);
        EXPECT_EQ(finished.status, 2) << arguments;
        EXPECT_EQ(std::count(finished.output.begin(), finished.output.end(), '\n'), 1) << finished.output;
        EXPECT_TRUE(contains(finished.output, part)) << finished.output;
    };
    expectOneLine("--features paper,shiny", "--features: no feature 'shiny', there are paper, physical, specular");
    expectOneLine("--features paper --preset figure-4", "--preset");
    expectOneLine("--features paper --error 0", "--error");
    expectOneLine("--features paper --fringes table", "--fringes");
    expectOneLine("--lower-normal-map", "--thickness-map");
    expectOneLine("--machine toaster", "--machine");
    expectOneLine("--uniforms some", "--uniforms");
    expectOneLine("--lights many", "--lights");
    expectOneLine("--unknown", "--unknown");
}

TEST(GlslTool, AFileAppearsWholeOrNotAtAll)
{
    const fs::path directory = fs::temp_directory_path() / ("nacre-glsl-test-" + std::to_string(getpid()));
    fs::create_directory(directory);
    const std::string inside = "cd '" + directory.string() + "' && ";
    EXPECT_EQ(run(inside + NACRE_GLSL " --preset figure-4 --out a.glsl").output, "");
    std::ifstream file(directory / "a.glsl");
    const std::string written((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    EXPECT_EQ(written, textOf("--preset figure-4"));
    // A file size limit of one block stops the write half-way, for root too.
    const Finished finished = run(inside + "trap '' XFSZ; ulimit -f 1; " NACRE_GLSL " --complete --out a.glsl");
    EXPECT_EQ(finished.status, 1) << finished.output;
    EXPECT_EQ(finished.output, "nacre-glsl: cannot write 'a.glsl': File too large\n");
    EXPECT_EQ(fs::file_size(directory / "a.glsl"), written.size());
    EXPECT_EQ(std::distance(fs::directory_iterator(directory), fs::directory_iterator()), 1);
    fs::remove_all(directory);
}

TEST(GlslTool, AFullDiskBehindStandardOutputIsNoticed)
{
    for (const std::string arguments : {"--preset figure-4", "--complete", "--list"}) {
        const Finished finished = run("(" NACRE_GLSL " " + arguments + " >/dev/full)");
        EXPECT_EQ(finished.status, 1) << arguments;
        EXPECT_EQ(finished.output, "nacre-glsl: cannot write to standard output: No space left on device\n") << arguments;
    }
}

}  // namespace
