// Noise, thickness and lower normal: the GLSL against its double-precision twin.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <nacre/evaluate.hpp>
#include <nacre/glsl.hpp>
#include <nacre/uniforms.hpp>

#include "gl/program.hpp"
#include "gpu.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

const char* const vertexShader = R"(#version 330 core
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
)";

// Powers of two, so that float32 and double precision start from the same position.
const char* const fragmentShader = R"(
layout(location = 0) out vec4 result;
void main()
{
    nacre_Material m = nacre_materialFromUniforms();
    vec3 p = vec3(gl_FragCoord.xy * 0.125 - 2.0, 0.40625);
    nacre_Surface s = nacre_surface(m, vec3(0.0, 0.6, 0.8), vec4(1.0, 0.0, 0.0, -1.0), p, mat3(1.0));
    result = vec4(s.lowerNormal, s.thicknessUm);
}
)";

// Every pixel of the GLSL for a material.
std::vector<glm::vec4> onGpu(const Material& material, int side)
{
    const demo::GlFunctions& gl = context().gl();
    static const GLuint program = *demo::linkProgram(gl, vertexShader, *glsl({330, false, GlslUniforms::plain}) + fragmentShader);
    static const Uniforms uniforms = *Uniforms::locate(context().getProcAddress(), program);
    GLuint framebuffer = 0, texture = 0, vertexArray = 0;
    gl.GenFramebuffers(1, &framebuffer);
    gl.GenTextures(1, &texture);
    gl.GenVertexArrays(1, &vertexArray);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, side, side, 0, GL_RGBA, GL_FLOAT, nullptr);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    gl.Viewport(0, 0, side, side);
    gl.BindVertexArray(vertexArray);
    gl.UseProgram(program);
    uniforms.set(*pack(material));
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4> pixels(static_cast<std::size_t>(side * side));
    gl.ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, pixels.data());
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.DeleteTextures(1, &texture);
    gl.DeleteVertexArrays(1, &vertexArray);
    return pixels;
}

// Returns how many pixels lie at the upper bound.
int expectAgreement(const Material& material, int side)
{
    int atBound = 0;
    const std::vector<glm::vec4> pixels = onGpu(material, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const glm::vec4 got = pixels[static_cast<std::size_t>(y * side + x)];
            const glm::dvec3 p((x + 0.5) * 0.125 - 2.0, (y + 0.5) * 0.125 - 2.0, 0.40625);
            const Surface expected = *surface(material, {0.0, 0.6, 0.8}, {1, 0, 0, -1}, p);
            // Noise at a frequency of 2^7 has lost 7 of its 24 bits: 1e-5 of the range, and of its gradient.
            const double range = material.thicknessMostNm - material.thicknessLeastNm;
            EXPECT_NEAR(static_cast<double>(got.w) * 1000.0, expected.thicknessNm, 1e-5 * range + 1e-6 * material.thicknessMostNm) << x << ' ' << y;
            EXPECT_GE(got.w, static_cast<float>(material.thicknessLeastNm / 1000.0));
            EXPECT_LE(got.w, static_cast<float>(material.thicknessMostNm / 1000.0));
            EXPECT_LE(glm::distance(glm::dvec3(got), expected.lowerNormal), 2e-5) << x << ' ' << y;
            atBound += expected.thicknessNm == material.thicknessMostNm;
        }
    }
    return atBound;
}

TEST(SurfaceGpu, AgreesWithItsTwinInEveryMode)
{
    for (const LowerNormal mode : {LowerNormal::parallel, LowerNormal::constant, LowerNormal::independent, LowerNormal::gradient}) {
        for (const double azimuth : {0.0, 50.0, -120.0}) {
            for (const int octaves : {0, 1, 3, 8}) {
                Material material;
                material.lowerNormal = mode;
                material.deviationDegrees = 17.0;
                material.azimuthDegrees = azimuth;
                material.noiseOctaves = octaves;
                material.noiseFrequency = 1.0;
                material.noiseSeed = 3 + octaves;
                expectAgreement(material, 32);
            }
        }
    }
}

// Where the noise reaches its bound the blend may round above it: that is the bound, not the other one.
TEST(SurfaceGpu, PlateausStayAtTheirBound)
{
    for (const double most : {79.0, 80.0, 200.0}) {  // 79 is a bound that the blend of 9 with it exceeds
        Material material;
        material.thicknessLeastNm = 9.0;
        material.thicknessMostNm = most;
        material.noiseFrequency = 5.6875;  // off the lattice, where the noise is 0
        EXPECT_GT(expectAgreement(material, 192), 10);
    }
}

}  // namespace
