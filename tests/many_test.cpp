// Arrays of materials and lights in buffers, as the README shows them.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <vector>

#include <nacre/nacre.hpp>

#include "gl/program.hpp"
#include "gpu.hpp"
#include "picture.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

std::string fileText(const char* name)
{
    std::ifstream file(name);
    return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

// The text between two marks.
std::string between(const std::string& text, const std::string& start, const std::string& end, std::size_t from = 0)
{
    const std::size_t first = text.find(start, from);
    if (first == std::string::npos) return {};
    const std::size_t after = first + start.size();
    return text.substr(after, text.find(end, after) - after);
}

std::string readmeSection()
{
    return between(fileText(NACRE_README), "### Many materials, many lights", "\n### ");
}

std::vector<Material> threeMaterials()
{
    std::vector<Material> materials{*preset("figure-3-right"), *preset("figure-2-centre"), *preset("figure-5-right")};
    materials[1].quality = Quality::physical;  // each has its own
    materials[2].lowerNormal = LowerNormal::gradient;
    return materials;
}

GLuint link(const std::string& fragmentShader, const std::string& vertexShader = pictureVertexShader)
{
    const Result<GLuint> program = demo::linkProgram(context().gl(), vertexShader, fragmentShader);
    if (!program) throw std::runtime_error(program.error().message);
    return *program;
}

// The README's code, word for word.
struct Readme {
    std::string fragmentShader;
    std::map<std::string, std::vector<unsigned char>> buffers;

    explicit Readme(const std::string& myMain)
    {
        const std::vector<Material> materials = threeMaterials();
        const auto upload = [&](const char* name, const void* bytes, std::size_t count) {
            const auto* first = static_cast<const unsigned char*>(bytes);
            buffers[name].assign(first, first + count);
        };
        // README {
        nacre::GlslOptions options;
        options.features.materials = 3;
        options.features.lights = 16;
        options.lights = true;
        fragmentShader = *nacre::glsl(options) + myMain;

        std::vector<nacre::Block> blocks;
        for (const nacre::Material& material : materials) blocks.push_back(*nacre::pack(material));
        upload("nacre_Block", blocks.data(), blocks.size() * sizeof(nacre::Block));

        nacre::LightSource lamp;
        lamp.kind = nacre::LightKind::spot;
        lamp.position = {0.0, 0.0, 3.0};
        lamp.intensity = 40.0;   // candela
        lamp.range = 10.0;
        const auto lights = nacre::packLights({lamp}, options.features.lights);   // or an error that names what is wrong
        upload("nacre_Lights", lights->data(), lights->size());
        // README }
    }
};

TEST(Many, TheReadmesHostCodeIsCompiledHere)
{
    std::string code = between(fileText(__FILE__), "        // README {\n", "        // README }");
    for (std::size_t at = 0; (at = code.find("        ", at)) != std::string::npos;) {
        if (at == 0 || code[at - 1] == '\n') code.erase(at, 8);
        else ++at;
    }
    ASSERT_GT(code.size(), 500U);
    EXPECT_EQ(between(readmeSection(), "```cpp\n", "```"), code);
}

TEST(Many, TheReadmesShaderDrawsWhatTheHostComputes)
{
    const Readme readme(between(readmeSection(), "```glsl\n", "```"));
    const GLuint program = link(readme.fragmentShader, R"(#version 330 core
out vec3 normal, position;
out vec4 tangent;
flat out int material;
void main()
{
    normal = vec3(0.0, 0.0, 1.0);
    position = vec3(0.125, 0.25, 0.5);
    tangent = vec4(1.0, 0.0, 0.0, 1.0);
    material = 1;
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)");
    std::vector<GLuint> buffers;
    for (const auto& [name, bytes] : readme.buffers) {
        buffers.push_back(bindBlock(context().gl(), program, name.c_str(), static_cast<GLuint>(buffers.size()), bytes.data(), bytes.size()));
    }
    ASSERT_EQ(buffers.size(), 2U);
    const glm::vec4 colour = drawPicture(context().gl(), program, 1, 1, 1)[0][0];  // the eye is at 0, behind the surface
    EXPECT_EQ(glm::vec3(colour), glm::vec3(0.0F));
    EXPECT_EQ(colour.w, 1.0F);
    context().gl().UseProgram(program);
    const float eye[3] = {1.0F, 0.5F, 4.0F};
    context().gl().Uniform3fv(context().gl().GetUniformLocation(program, "eye"), 1, eye);
    const glm::vec3 lit = drawPicture(context().gl(), program, 1, 1, 1)[0][0];

    const Material material = threeMaterials()[1];
    const glm::dvec3 position(0.125, 0.25, 0.5), toLight = glm::dvec3(0.0, 0.0, 3.0) - position;
    const double squared = glm::dot(toLight, toLight);
    const Surface s = *surface(material, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0, 1.0}, position);
    const Evaluation evaluation = *evaluate(material, s, glm::normalize(toLight), glm::normalize(glm::dvec3(1.0, 0.5, 4.0) - position));
    // On the spot's axis to 6 degrees of 45: the smooth cone leaves less than all.
    const double window = 1.0 - squared * squared / 1e4, cone = (toLight.z / std::sqrt(squared) - std::sqrt(0.5)) / (1.0 - std::sqrt(0.5));
    const glm::dvec3 expected = evaluation.shaded * (40.0 * window / squared * cone * cone);
    EXPECT_GT(expected.g, 0.1);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(lit[channel], expected[channel], 1e-3 * expected[channel]) << channel;
    for (GLuint buffer : buffers) context().gl().DeleteBuffers(1, &buffer);
    context().gl().DeleteProgram(program);
}

const char* const readsMembers = R"(
layout(location = 0) out vec4 first;
layout(location = 1) out vec4 second;
layout(location = 2) out vec4 third;
void main()
{
    nacre_Material m = nacre_material(INDEX);
    first = vec4(m.eta, m.upperExponent);
    second = vec4(m.diffuseFringe, m.thicknessMostUm);
    third = vec4(m.azimuthSin, float(m.noiseSeed), float(m.lowerNormal), float(m.quality));
}
)";

GLuint membersProgram(int materials, const std::string& index)
{
    GlslOptions options;
    options.features.materials = materials;
    return link(*glsl(options) + "uniform int material;\n#define INDEX " + index + '\n' + readsMembers);
}

TEST(Many, AnIndexPerPixelReadsThatMaterial)
{
    std::vector<Block> blocks;
    for (const Material& material : threeMaterials()) blocks.push_back(*pack(material));
    for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i].noiseSeed = 100 + static_cast<int>(i);
    const GLuint program = membersProgram(3, "(int(gl_FragCoord.x) * 2 + int(gl_FragCoord.y)) % 3");
    const GLuint buffer = bindBlock(context().gl(), program, "nacre_Block", 0, blocks.data(), blocks.size() * sizeof(Block));
    const auto pictures = drawPicture(context().gl(), program, 8, 8, 3);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const Block& b = blocks[static_cast<std::size_t>((x * 2 + y) % 3)];
            const auto pixel = static_cast<std::size_t>(y * 8 + x);
            EXPECT_EQ(pictures[0][pixel], glm::vec4(b.eta[0], b.eta[1], b.eta[2], b.upperExponent));
            EXPECT_EQ(pictures[1][pixel], glm::vec4(b.diffuseFringe[0], b.diffuseFringe[1], b.diffuseFringe[2], b.thicknessMostUm));
            EXPECT_EQ(pictures[2][pixel], glm::vec4(b.azimuthSin, b.noiseSeed, b.lowerNormal, b.quality));
        }
    }
    context().gl().DeleteBuffers(1, &buffer);
    context().gl().DeleteProgram(program);
}

// An index per draw: a uniform of the host's; the last of as many as every driver has room for.
TEST(Many, TheLastOfSixtyFourIsRead)
{
    std::vector<Block> blocks(64, *pack(Material{}));
    blocks.back() = *pack(threeMaterials()[2]);
    const GLuint program = membersProgram(64, "material");
    const GLuint buffer = bindBlock(context().gl(), program, "nacre_Block", 0, blocks.data(), blocks.size() * sizeof(Block));
    context().gl().UseProgram(program);
    for (const int index : {63, 62, 0}) {
        context().gl().Uniform1i(context().gl().GetUniformLocation(program, "material"), index);
        EXPECT_EQ(drawPicture(context().gl(), program, 1, 1, 3)[0][0].w, blocks[static_cast<std::size_t>(index)].upperExponent);
    }
    EXPECT_NE(blocks[62].upperExponent, blocks[63].upperExponent);
    context().gl().DeleteBuffers(1, &buffer);
    context().gl().DeleteProgram(program);
}

}  // namespace
