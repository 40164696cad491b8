// Lights: analytic limits of the model, the GLSL against it, and the contract of the block.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <nacre/glsl.hpp>
#include <nacre/lights.hpp>

#include "gl/program.hpp"
#include "gpu.hpp"
#include "model/lights.hpp"
#include "picture.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

LightSource lamp(LightKind kind = LightKind::point, double range = 0.0)
{
    LightSource light;
    light.kind = kind;
    light.colour = {1.0, 0.5, 0.25};
    light.intensity = 8.0;
    light.range = range;
    return light;
}

// What reaches a point on the negative z axis, where the light shines by default, at this angle from that axis.
model::Incidence at(const LightSource& light, double distance, double degrees = 0.0)
{
    const double angle = glm::radians(degrees);
    return model::incidence(model::derive(light), light.position + distance * glm::dvec3(std::sin(angle), 0.0, -std::cos(angle)));
}

TEST(Lights, DirectionalIsTheSameEverywhere)
{
    LightSource sun = lamp(LightKind::directional);
    sun.direction = {0.0, -3.0, 4.0};
    for (const double distance : {0.0, 1.0, 1e9}) {
        EXPECT_LT(glm::distance(at(sun, distance).direction, glm::dvec3(0.0, 0.6, -0.8)), 1e-15);
        EXPECT_EQ(at(sun, distance).radiance, glm::dvec3(8.0, 4.0, 2.0));
    }
}

TEST(Lights, PointFollowsTheInverseSquare)
{
    for (const double distance : {1e-3, 0.5, 1.0, 3.0, 1e6}) {
        EXPECT_NEAR(at(lamp(), distance).radiance.r * distance * distance, 8.0, 1e-12);
        EXPECT_NEAR(at(lamp(), distance, 77.0).radiance.b * distance * distance, 2.0, 1e-12);
        EXPECT_LT(glm::distance(at(lamp(), distance).direction, glm::dvec3(0.0, 0.0, 1.0)), 1e-15);
    }
}

TEST(Lights, EndAtTheirRange)
{
    const LightSource light = lamp(LightKind::point, 10.0);
    EXPECT_EQ(at(light, 10.0).radiance, glm::dvec3(0.0));
    EXPECT_EQ(at(light, 11.0).radiance, glm::dvec3(0.0));
    EXPECT_GT(at(light, 9.999).radiance.r, 0.0);
    EXPECT_NEAR(at(light, 5.0).radiance.r, 8.0 / 25.0 * (1.0 - 1.0 / 16.0), 1e-15);
    EXPECT_NEAR(at(light, 0.01).radiance.r * 1e-4, 8.0, 1e-10);  // of the window 1e-12 is left
}

TEST(Lights, SpotHasItsConesEdges)
{
    LightSource spot = lamp(LightKind::spot);
    spot.innerConeDegrees = 20.0;
    spot.outerConeDegrees = 40.0;
    EXPECT_NEAR(at(spot, 2.0).radiance.r, 2.0, 1e-14);
    EXPECT_NEAR(at(spot, 2.0, 20.0).radiance.r, 2.0, 1e-13);
    EXPECT_NEAR(at(spot, 2.0, 40.0).radiance.r, 0.0, 1e-13);
    EXPECT_EQ(at(spot, 2.0, 41.0).radiance, glm::dvec3(0.0));
    EXPECT_EQ(at(spot, 2.0, 180.0).radiance, glm::dvec3(0.0));
    // Half-way in cosine: a quarter.
    const double middle = glm::degrees(std::acos(0.5 * (std::cos(glm::radians(20.0)) + std::cos(glm::radians(40.0)))));
    EXPECT_NEAR(at(spot, 2.0, middle).radiance.r, 0.5, 1e-13);
}

TEST(Lights, NothingComesFromWhereTheLightIs)
{
    for (const LightKind kind : {LightKind::point, LightKind::spot}) {
        EXPECT_EQ(at(lamp(kind), 0.0).direction, glm::dvec3(0.0));
        EXPECT_EQ(at(lamp(kind), 0.0).radiance, glm::dvec3(0.0));
        EXPECT_EQ(at(lamp(kind), 1e-9).radiance, at(lamp(kind), 1e-7).radiance);
        EXPECT_EQ(at(lamp(kind), std::numeric_limits<double>::infinity(), 45.0).radiance, glm::dvec3(0.0));
    }
}

TEST(Lights, ABadLightIsAnError)
{
    const auto fault = [](auto change) {
        LightSource light = lamp(LightKind::spot);
        change(light);
        const Result<LightBlock> block = packLight(light);
        return block ? std::string("none") : block.error().message;
    };
    EXPECT_EQ(fault([](LightSource&) {}), "none");
    EXPECT_EQ(fault([](LightSource& l) { l.intensity = -1.0; }), "nacre::packLight(): expected 0 <= intensity <= 1e+09, got -1");
    EXPECT_EQ(fault([](LightSource& l) { l.colour.g = NAN; }), "nacre::packLight(): expected 0 <= colour.g <= 1e+09, got nan");
    EXPECT_EQ(fault([](LightSource& l) { l.position.z = INFINITY; }), "nacre::packLight(): expected -1e+12 <= position.z <= 1e+12, got inf");
    EXPECT_EQ(fault([](LightSource& l) { l.range = -2.0; }), "nacre::packLight(): expected 0 <= range <= 1e+12, got -2");
    EXPECT_EQ(fault([](LightSource& l) { l.outerConeDegrees = 91.0; }), "nacre::packLight(): expected 0 <= outerConeDegrees <= 90, got 91");
    EXPECT_EQ(fault([](LightSource& l) { l.innerConeDegrees = 45.0; }), "nacre::packLight(): expected innerConeDegrees < outerConeDegrees (45), got 45");
    EXPECT_EQ(fault([](LightSource& l) { l.direction = glm::dvec3(0.0); }), "nacre::packLight(): expected a direction of a length other than 0, got 0,0,0");
    EXPECT_EQ(fault([](LightSource& l) { l.kind = static_cast<LightKind>(3); }), "nacre::packLight(): expected 0 <= kind <= 2, got 3");
    // What a kind has no use for may be anything.
    LightSource sun = lamp(LightKind::directional, -1.0);
    sun.position.x = NAN;
    EXPECT_TRUE(packLight(sun));

    LightSource dark = lamp();
    dark.intensity = -1.0;
    EXPECT_EQ(packLights({lamp(), dark}, 2).error().message, "nacre::packLights(): lights[1]: expected 0 <= intensity <= 1e+09, got -1");
    EXPECT_EQ(packLights({lamp(), lamp()}, 1).error().message, "nacre::packLights(): expected at most 1 lights, got 2");
    EXPECT_EQ(packLights({}, 0).error().message, "nacre::packLights(): expected room for 1 light or more, got 0");
}

GlslOptions withLights(int count, bool stableLobes = true)
{
    GlslOptions options;
    options.features.physical = false;  // or every form is the stable one
    options.features.stableLobes = stableLobes;
    options.uniforms = GlslUniforms::none;
    options.lights = true;
    options.features.lights = count;
    return options;
}

TEST(Lights, ABlockHoldsAsManyAsEveryDriverPromises)
{
    EXPECT_TRUE(glsl(withLights(255)));
    EXPECT_EQ(packLights({}, 255)->size(), 16384U - 48U);
    EXPECT_EQ(glsl(withLights(256)).error().message, "nacre::glsl(): expected at most 255 lights in the block, got 256");
    EXPECT_EQ(glsl()->find("nacre_Lights"), std::string::npos);
}

const char* const usesLights = R"(
layout(location = 0) out vec4 direction;
layout(location = 1) out vec4 radiance;
void main()
{
    nacre_LightSource source = nacre_lightSource(int(gl_FragCoord.x));
    nacre_Incidence light = nacre_incidence(source, vec3(gl_FragCoord.y * 0.25 - 4.125, 0.5, -1.25));
    direction = vec4(light.direction, float(nacre_lightCount()));
    radiance = vec4(light.radiance, 1.0);
}
)";

GLuint lightsProgram(int count, bool stableLobes = true)
{
    const Result<GLuint> program = demo::linkProgram(context().gl(), pictureVertexShader, *glsl(withLights(count, stableLobes)) + usesLights);
    if (!program) throw std::runtime_error(program.error().message);
    return *program;
}

TEST(LightBlock, EveryMemberLiesWhereTheHostHasIt)
{
    const demo::GlFunctions& gl = context().gl();
    const GLuint id = lightsProgram(3);
    GLint size = 0;
    gl.GetActiveUniformBlockiv(id, gl.GetUniformBlockIndex(id, "nacre_Lights"), GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    EXPECT_EQ(static_cast<std::size_t>(size), packLights({}, 3)->size());
    const auto expectAt = [&](const char* name, std::size_t expected) {
        GLuint uniform = 0;
        GLint offset = -1;
        gl.GetUniformIndices(id, 1, &name, &uniform);
        ASSERT_NE(uniform, GL_INVALID_INDEX) << name;
        gl.GetActiveUniformsiv(id, 1, &uniform, GL_UNIFORM_OFFSET, &offset);
        EXPECT_EQ(static_cast<std::size_t>(offset), expected) << name;
    };
    const std::size_t second = sizeof(LightHeader) + sizeof(LightBlock);
    expectAt("nacre_u_lightCount", offsetof(LightHeader, count));
    expectAt("nacre_u_lights[1].colour", second + offsetof(LightBlock, colour));
    expectAt("nacre_u_lights[1].inverseRange", second + offsetof(LightBlock, inverseRange));
    expectAt("nacre_u_lights[1].position", second + offsetof(LightBlock, position));
    expectAt("nacre_u_lights[1].kind", second + offsetof(LightBlock, kind));
    expectAt("nacre_u_lights[1].direction", second + offsetof(LightBlock, direction));
    expectAt("nacre_u_lights[1].angleScale", second + offsetof(LightBlock, angleScale));
    expectAt("nacre_u_lights[1].angleOffset", second + offsetof(LightBlock, angleOffset));
    gl.DeleteProgram(id);
}

// Positions in eighths, which float32 holds: what differs is arithmetic alone.
std::vector<LightSource> manyLights(int count)
{
    std::mt19937 random(7);
    const auto eighths = [&](int most) { return static_cast<double>(std::uniform_int_distribution<int>(-8 * most, 8 * most)(random)) / 8.0; };
    const auto upTo = [&](double most) { return std::uniform_real_distribution<double>(0.0, most)(random); };
    std::vector<LightSource> lights;
    for (int i = 0; i < count; ++i) {
        LightSource light = lamp(static_cast<LightKind>(i % 3), i % 2 ? 1.0 + upTo(9.0) : 0.0);
        light.position = {eighths(4), eighths(4), eighths(4)};
        light.direction = {eighths(2), eighths(2), 2.25};
        light.outerConeDegrees = 20.0 + upTo(70.0);
        light.innerConeDegrees = upTo(light.outerConeDegrees - 5.0);
        lights.push_back(light);
    }
    lights.front().kind = LightKind::point;  // and one that lies on a pixel's point
    lights.front().position = {0.0, 0.5, -1.25};
    return lights;
}

// Directions have two forms.
class LightsGpu : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Forms, LightsGpu, testing::Bool());

TEST_P(LightsGpu, AgreesWithItsTwin)
{
    constexpr int count = 200, rows = 33;
    const std::vector<LightSource> lights = manyLights(count);
    const GLuint program = lightsProgram(count, GetParam());
    const std::vector<unsigned char> bytes = *packLights(lights, count);
    const GLuint buffer = bindBlock(context().gl(), program, "nacre_Lights", 0, bytes.data(), bytes.size());
    const auto pictures = drawPicture(context().gl(), program, count, rows, 2);
    int dark = 0, lit = 0;
    for (int i = 0; i < count; ++i) {
        const model::LightSource source = model::derive(lights[static_cast<std::size_t>(i)]);
        for (int y = 0; y < rows; ++y) {
            const auto pixel = static_cast<std::size_t>(y * count + i);
            const glm::dvec4 direction = pictures[0][pixel];
            const glm::dvec3 radiance = pictures[1][pixel];
            const glm::dvec3 position((y + 0.5) * 0.25 - 4.125, 0.5, -1.25), toLight = source.position - position;
            const model::Incidence expected = model::incidence(source, position);
            EXPECT_EQ(direction.w, count);
            ASSERT_LE(glm::distance(glm::dvec3(direction), expected.direction), 5e-7) << i << ' ' << y;
            // A cone's share errs by the cosine's rounding times the cone's scale, the window near its end by that of 1:
            // both against what would arrive without them.
            const bool isDirectional = source.kind == LightKind::directional;
            const double whole = source.colour.r / (isDirectional ? 1.0 : std::max(glm::dot(toLight, toLight), 1e-12));
            ASSERT_LE(glm::distance(radiance, expected.radiance), 1e-7 * (8.0 + 4.0 * source.angleScale) * whole) << i << ' ' << y;
            (expected.radiance.r > 0.0 ? lit : dark) += 1;
        }
    }
    EXPECT_GT(dark, 500);  // both cases are there
    EXPECT_GT(lit, 2000);
    context().gl().DeleteBuffers(1, &buffer);
    context().gl().DeleteProgram(program);
}

// Bit patterns that are not meant to happen: nothing that is not a number comes out.
TEST_P(LightsGpu, IsFiniteWhateverTheLight)
{
    const float extremes[] = {0.0F, 1e-45F, 1e-30F, 1e-22F, 1e-20F, 1e-19F, 2e-19F, 1e-12F, 1.0F, 1e12F, 1e20F, 3e38F};
    std::vector<LightBlock> blocks;
    for (const float at : extremes) {
        for (const float inverseRange : {0.0F, 1e-30F, 1.0F, 1e30F}) {
            for (const int kind : {1, 2}) {
                LightBlock block = *packLight(lamp(static_cast<LightKind>(kind)));
                block.position[0] = at;
                block.position[1] = 0.5F;
                block.position[2] = -1.25F;
                block.inverseRange = inverseRange;
                for (float& channel : block.colour) channel = 1e18F;
                blocks.push_back(block);
            }
        }
    }
    const int count = static_cast<int>(blocks.size());
    std::vector<unsigned char> bytes = *packLights({}, count);
    const std::int32_t shown = count + 7;  // more than there is room for
    std::memcpy(bytes.data(), &shown, sizeof shown);
    std::memcpy(bytes.data() + sizeof(LightHeader), blocks.data(), blocks.size() * sizeof(LightBlock));
    const GLuint program = lightsProgram(count, GetParam());
    const GLuint buffer = bindBlock(context().gl(), program, "nacre_Lights", 0, bytes.data(), bytes.size());
    for (const auto& picture : drawPicture(context().gl(), program, count, 33, 2)) {
        for (const glm::vec4& pixel : picture) {
            ASSERT_TRUE(std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z));
            ASSERT_TRUE(pixel.w == 1.0F || pixel.w == static_cast<float>(count));
        }
    }
    context().gl().DeleteBuffers(1, &buffer);
    context().gl().DeleteProgram(program);
}

}  // namespace
