// The contract between nacre::Block and the GLSL: same names, same places, same values, both ways to set them.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <set>

#include <nacre/block.hpp>
#include <nacre/glsl.hpp>
#include <nacre/presets.hpp>
#include <nacre/uniforms.hpp>

#include "gl/program.hpp"
#include "gpu.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

const char* const vertexShader = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";

// A material of every member is read by no one shader: what follows from the thickness is for those of a constant one.
// So the two texts of all features, and of them with a constant thickness.
std::vector<Features> wholeFeatures()
{
    Features constant;
    constant.thickness = ThicknessSource::constant;
    constant.lowerNormals = LowerNormals::constant;
    return {Features{}, constant};
}

const char* const usesAll = R"(
out vec4 colour;
uniform sampler2D fringeTable;
void main()
{
    nacre_Material m = nacre_materialFromUniforms();
    nacre_Surface s = nacre_surface(m, vec3(0.0, 0.0, 1.0), vec4(1.0, 0.0, 0.0, 1.0), gl_FragCoord.xyz, mat3(1.0));
    nacre_Shading w = nacre_shading(m, s, vec3(0.0, 0.6, 0.8));
    colour = vec4(nacre_shade(m, w, normalize(gl_FragCoord.xyz)), 1.0);
    w = nacre_shading(m, s, vec3(0.0, 0.6, 0.8), fringeTable);
    colour.xyz += nacre_shade(m, w, normalize(gl_FragCoord.xyz), fringeTable);
}
)";

GLuint program(GlslUniforms uniforms, const char* main = usesAll, const Features& features = {})
{
    const std::string library = *glsl({330, false, uniforms, features});
    const Result<GLuint> program = demo::linkProgram(context().gl(), vertexShader, library + main);
    if (!program) throw std::runtime_error(program.error().message);
    return *program;
}

TEST(Block, EveryMemberOfTheGlslBlockLiesWhereBlockHasIt)
{
    const demo::GlFunctions& gl = context().gl();
    const GLuint id = program(GlslUniforms::block);
    const GLuint index = gl.GetUniformBlockIndex(id, "nacre_Block");
    ASSERT_NE(index, GL_INVALID_INDEX);
    GLint size = 0, count = 0;
    gl.GetActiveUniformBlockiv(id, index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    gl.GetActiveUniformBlockiv(id, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, &count);
    EXPECT_EQ(static_cast<std::size_t>(size), sizeof(Block));
    EXPECT_EQ(static_cast<std::size_t>(count), blockMembers().size() + 2);  // what fills the last two rows
    for (const BlockMember& member : blockMembers()) {
        GLuint uniform = 0;
        GLint offset = -1, type = 0;
        const std::string name = std::string("nacre_Block.nacre_packed[0].") + member.uniform, plain = name.substr(12);
        const char* names[] = {plain.c_str()};
        gl.GetUniformIndices(id, 1, names, &uniform);
        ASSERT_NE(uniform, GL_INVALID_INDEX) << member.uniform;
        gl.GetActiveUniformsiv(id, 1, &uniform, GL_UNIFORM_OFFSET, &offset);
        gl.GetActiveUniformsiv(id, 1, &uniform, GL_UNIFORM_TYPE, &type);
        EXPECT_EQ(static_cast<std::size_t>(offset), member.offset) << member.uniform;
        const GLenum expected = member.type == BlockMember::Type::vec3   ? GL_FLOAT_VEC3
                                : member.type == BlockMember::Type::real ? GL_FLOAT
                                                                         : GL_INT;
        EXPECT_EQ(static_cast<GLenum>(type), expected) << member.uniform;
    }
    gl.DeleteProgram(id);
}

TEST(Block, MembersCoverTheBlock)
{
    std::set<std::size_t> words;
    for (const BlockMember& member : blockMembers()) {
        const std::size_t count = member.type == BlockMember::Type::vec3 ? 3 : 1;
        for (std::size_t i = 0; i < count; ++i) EXPECT_TRUE(words.insert(member.offset / 4 + i).second) << member.uniform;
    }
    words.insert(offsetof(Block, unused0) / 4);
    words.insert(offsetof(Block, unused1) / 4);
    EXPECT_EQ(words.size(), sizeof(Block) / 4);
    EXPECT_EQ(*words.rbegin(), sizeof(Block) / 4 - 1);
}

TEST(Uniforms, EveryValueArrives)
{
    const demo::GlFunctions& gl = context().gl();
    Material material = *preset("figure-3-right");
    material.quality = Quality::physical;  // no enumeration is left at 0, where a uniform starts
    material.substrate = Substrate::metal;
    material.substrateAbsorption = glm::dvec3(3.0);
    material.lobes = Lobes::normalised;
    const Block block = *pack(material);
    std::set<std::string> arrived;
    for (const Features& features : wholeFeatures()) {
        const GLuint id = program(GlslUniforms::plain, usesAll, features);
        const Result<Uniforms> uniforms = Uniforms::locate(context().getProcAddress(), id);
        ASSERT_TRUE(uniforms) << uniforms.error().message;
        gl.UseProgram(id);
        uniforms->set(block);
        for (const BlockMember& member : blockMembers()) {
            const GLint location = gl.GetUniformLocation(id, member.uniform);
            if (location < 0) continue;  // not for these features
            arrived.insert(member.uniform);
            float got[3] = {NAN, NAN, NAN};
            if (member.type == BlockMember::Type::integer) {
                GLint whole = -1;
                gl.GetUniformiv(id, location, &whole);
                std::memcpy(got, &whole, sizeof whole);
            } else {
                gl.GetUniformfv(id, location, got);
            }
            const std::size_t size = member.type == BlockMember::Type::vec3 ? 12 : 4;
            EXPECT_EQ(std::memcmp(got, reinterpret_cast<const char*>(&block) + member.offset, size), 0) << member.uniform;
        }
        EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
        gl.DeleteProgram(id);
    }
    EXPECT_EQ(arrived.size(), blockMembers().size());
}

// The README's shader, as it is printed there, behind the library's text.
TEST(Readme, ShaderCompilesAndLinks)
{
    std::ifstream file(NACRE_README);
    const std::string readme((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const std::size_t start = readme.find("```glsl\n");
    ASSERT_NE(start, std::string::npos);
    const std::size_t end = readme.find("```", start + 8);
    const std::string snippet = readme.substr(start + 8, end - start - 8);
    const Result<GLuint> linked =
        demo::linkProgram(context().gl(),
                          "#version 330 core\nout vec3 normal, position;\nout vec4 tangent;\n"
                          "void main() { normal = position = vec3(1.0); tangent = vec4(1.0); gl_Position = vec4(0.0); }\n",
                          *glsl() + snippet);
    ASSERT_TRUE(linked) << linked.error().message;
    context().gl().DeleteProgram(*linked);
}

TEST(Uniforms, AnOptimisedAwayUniformIsNoError)
{
    const GLuint id = program(GlslUniforms::plain, "out vec4 colour; void main() { colour = vec4(nacre_materialFromUniforms().eta, 1.0); }\n");
    const Result<Uniforms> uniforms = Uniforms::locate(context().getProcAddress(), id);
    ASSERT_TRUE(uniforms) << uniforms.error().message;
    context().gl().UseProgram(id);
    uniforms->set(*pack(Material{}));
    EXPECT_EQ(context().gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
    context().gl().DeleteProgram(id);
}

TEST(Uniforms, AWrongProgramIsAnError)
{
    const demo::GlFunctions& gl = context().gl();
    EXPECT_EQ(Uniforms::locate(context().getProcAddress(), 4711).error().message,
              "nacre::Uniforms::locate(): expected the name of a program, got 4711");
    const GLuint empty = gl.CreateProgram();
    EXPECT_EQ(Uniforms::locate(context().getProcAddress(), empty).error().message,
              "nacre::Uniforms::locate(): expected a linked program, got " + std::to_string(empty));
    gl.DeleteProgram(empty);
    const GLuint block = program(GlslUniforms::block);
    EXPECT_EQ(Uniforms::locate(context().getProcAddress(), block).error().message,
              "nacre::Uniforms::locate(): expected a program with nacre's plain uniforms, got " + std::to_string(block) +
                  ", which has none; was it assembled with GlslUniforms::plain?");
    gl.DeleteProgram(block);
    EXPECT_EQ(Uniforms::locate(nullptr, 1).error().message,
              "nacre::Uniforms::locate(): expected a GetProcAddress function, got null");
    EXPECT_EQ(Uniforms::locate([](const char*) -> void (*)() { return nullptr; }, 1).error().message,
              "nacre::Uniforms::locate(): the host's GetProcAddress does not know glIsProgram; is a context of OpenGL 2.0 or "
              "OpenGL ES 2.0 current?");
}

}  // namespace
