// The assembled text: every version it is offered for, and what engines are known to stumble over.

#include <gtest/gtest.h>

#include <regex>

#include <nacre/glsl.hpp>

namespace {

using namespace nacre;

TEST(Glsl, StartsWithItsVersion)
{
    EXPECT_EQ(glsl()->substr(0, 18), "#version 330 core\n");
    EXPECT_EQ(glsl({300, true})->substr(0, 60), "#version 300 es\nprecision highp float;\nprecision highp int;\n");
    EXPECT_EQ(glsl({120}).error().message, "nacre::glsl(): expected version 330, 400 to 460 in tens, with es 300, 310, 320, or with vulkan 450, 460, got 120");
    EXPECT_FALSE(glsl({330, true}));
    EXPECT_FALSE(glsl({300}));
}

TEST(Glsl, HoldsOneDeclarationOfTheMaterial)
{
    const auto has = [](GlslUniforms uniforms, const char* text) { return glsl({330, false, uniforms})->find(text) != std::string::npos; };
    EXPECT_TRUE(has(GlslUniforms::block, "uniform nacre_Block"));
    EXPECT_FALSE(has(GlslUniforms::block, "uniform vec3"));
    EXPECT_TRUE(has(GlslUniforms::plain, "uniform vec3 nacre_u_eta"));
    EXPECT_FALSE(has(GlslUniforms::plain, "uniform nacre_Block"));
    EXPECT_FALSE(has(GlslUniforms::none, "nacre_u_"));
}

// A file that goes into an engine as it is: see the subset in the README.
TEST(Glsl, FilesKeepToTheSubsetThatEnginesAccept)
{
    ASSERT_GE(glslFiles().size(), 18U);
    for (const GlslFile& file : glslFiles()) {
        const std::string text(file.text);
        const std::string name(file.name);
        EXPECT_EQ(name.find('/'), std::string::npos);
        std::string guard = name;
        for (char& c : guard) c = c == '.' ? '_' : static_cast<char>(std::toupper(c));
        EXPECT_EQ(text.find("#ifndef " + guard + "\n#define " + guard + "\n"), 0U) << name;
        for (const char* banned : {"##", "\xEF\xBB\xBF", "#include", "#version", "#extension", "precision ", " main("}) {
            EXPECT_EQ(text.find(banned), std::string::npos) << name << " has " << banned;
        }
        // Before 4.20 GLSL's source is ASCII, comments included; some drivers insist.
        for (const char c : text) ASSERT_TRUE(c == '\n' || (c >= ' ' && c <= '~')) << name << " has the byte " << static_cast<int>(c);
        const std::string code = std::regex_replace(text, std::regex("//[^\n]*"), "");
        for (const char* word : {"sample", "patch", "input", "half", "texture"}) {
            EXPECT_FALSE(std::regex_search(code, std::regex("\\b" + std::string(word) + "\\b"))) << name << " uses " << word;
        }
        EXPECT_FALSE(std::regex_search(code, std::regex("uniform[^;{]*="))) << name << ": a default uniform value";
        if (name != "nacre_uniforms.glsl" && name != "nacre_uniform_block.glsl") {
            EXPECT_FALSE(std::regex_search(code, std::regex("\\b(uniform|in|attribute|varying)\\s+(highp\\s+)?\\w+\\s+\\w+\\s*;"))) << name;
        }
        // Every function and struct carries the prefix.
        const std::regex definition("(?:^|\n)(?:void|float|int|uint|vec2|vec3|vec4|mat3|struct|nacre_\\w+) (\\w+)\\(");
        for (std::sregex_iterator it(code.begin(), code.end(), definition), end; it != end; ++it) {
            EXPECT_EQ((*it)[1].str().substr(0, 6), "nacre_") << name;
        }
    }
}

}  // namespace
