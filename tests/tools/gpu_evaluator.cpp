#include "gpu_evaluator.hpp"

#include <algorithm>
#include <cstring>

#include <nacre/fringe_table.hpp>
#include <nacre/glsl.hpp>

#include "gl/program.hpp"

namespace nacre::test {
namespace {

// A batch is a picture of side × side pixels; its inputs a texture of as many columns per pixel as
// an input has texels. 128 × 18 texels wide is within every driver's limits.
constexpr int side = 128;
constexpr int blockTexels = sizeof(Block) / 16;
constexpr int texels = blockTexels + 5;
constexpr int targets = 8;

const char* const vertexShader = R"(#version 330 core
void main()  // one triangle that covers the picture
{
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

// The block's integers that matter here are repeated as numbers; directions and thickness are inputs.
const char* const fragmentShader = R"(
uniform sampler2D inputs;
#if FRINGE_TABLE == 1
uniform sampler2D fringeTable;
#define FRINGE_ARGUMENT , fringeTable
#else
#define FRINGE_ARGUMENT
#endif
layout(location = 0) out vec3 rho;
layout(location = 1) out vec3 R;
layout(location = 2) out vec3 T;
layout(location = 3) out vec3 phi;
layout(location = 4) out vec3 diffuse;
layout(location = 5) out vec3 meanCos;
layout(location = 6) out vec3 shaded;
layout(location = 7) out vec3 lobes;

vec4 texel(int index)
{
    return texelFetch(inputs, ivec2(int(gl_FragCoord.x) * TEXELS + index, int(gl_FragCoord.y)), 0);
}

void main()
{
    nacre_Material m;
    m.eta = texel(0).xyz;
    m.upperExponent = texel(0).w;
    m.etaSquared = texel(1).xyz;
    m.lowerExponent = texel(1).w;
    m.oneMinusEtaSquared = texel(2).xyz;
    m.specularWeight = texel(2).w;
    m.normalReflectance = texel(3).xyz;
    m.diffuseWeight = texel(3).w;
    m.cyclesPerUm = texel(4).xyz;
    m.cyclesPerUmTail = texel(5).xyz;
    m.diffuseFringe = texel(6).xyz;

    m.index = texel(9).xyz;
    m.upperScale = texel(9).w;
    m.substrateReal = texel(10).xyz;
    m.lowerScale = texel(10).w;
    m.substrateImaginary = texel(11).xyz;
    m.diffuseAlbedo = texel(12).xyz;
    m.quality = int(texel(17).x);
    m.substrate = int(texel(17).y);
    m.lobes = int(texel(17).z);

    vec3 l = texel(13).xyz;
    nacre_Surface s;
    s.thicknessUm = texel(13).w;
    s.upperNormal = texel(15).xyz;
    s.lowerNormal = texel(16).xyz;

    nacre_View w = nacre_view(m, s, texel(14).xyz);
    nacre_Terms t = nacre_terms(m, w, l);
    if (m.quality == NACRE_QUALITY_PHYSICAL) {
        nacre_PhysicalView physical = nacre_physicalView(m, s, texel(14).xyz FRINGE_ARGUMENT);
        nacre_PhysicalTerms p = nacre_physicalTerms(m, physical, l);
        rho = nacre_physicalSpecular(m, physical, l FRINGE_ARGUMENT);
        for (int channel = 0; channel < 3; ++channel) {
            nacre_Film film = nacre_filmOf(m.eta[channel], m.oneMinusEtaSquared[channel],
                                           vec2(m.substrateReal[channel], m.substrateImaginary[channel]), m.substrate,
                                           p.cosHalfSquared, vec2(p.crossingS[channel], p.crossingP[channel]));
            R[channel] = film.upper * p.rootUpper * p.rootUpper;
            T[channel] = film.lower * p.rootLower[channel] * p.rootLower[channel];
        }
        diffuse = physical.diffuse;
        shaded = nacre_physicalLight(m, physical, l FRINGE_ARGUMENT);
    } else {
        rho = nacre_specular(m, w, l);
        R = t.sqrtR * t.sqrtR;
        T = t.sqrtT * t.sqrtT;
        diffuse = w.diffuse;
        shaded = nacre_light(m, w, l);
    }
    vec3 inside = nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, clamp(dot(w.upperNormal, l), 0.0, 1.0));
    bvec3 hasRays = greaterThan(min(inside, w.cosRefracted), vec3(0.0));
    // Whole cycles and all, which the library leaves out.
    vec3 cycles = (m.cyclesPerUm + m.cyclesPerUmTail) * s.thicknessUm * (sqrt(max(inside, 0.0)) + w.cosRefracted);
    phi = mix(vec3(0.0), 3.14159265 * cycles, hasRays);
    meanCos = nacre_meanRefractedCosine(m.eta, m.oneMinusEtaSquared, m.normalReflectance);
    lobes = vec3(t.upperOneMinus, t.lowerOneMinus.r, t.lowerOneMinus.b);
}
)";

void pack(const GpuInput& input, float* target)
{
    std::memcpy(target, &input.block, sizeof(Block));
    float* const vectors = target + blockTexels * 4;
    const auto put = [&](int index, glm::vec3 value) { std::copy_n(&value.x, 3, vectors + index * 4); };
    put(0, input.light);
    vectors[3] = input.thicknessUm;
    put(1, input.view);
    put(2, input.upperNormal);
    put(3, input.lowerNormal);
    put(4, {input.block.quality, input.block.substrate, input.block.lobes});
}

void makeTexture(const demo::GlFunctions& gl, GLuint texture, GLint format, int width)
{
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, format, width, side, 0, GL_RGBA, GL_FLOAT, nullptr);
}

}  // namespace

Result<GpuEvaluator> GpuEvaluator::create(const demo::Context& context, FringeForm form)
{
    GpuEvaluator evaluator(context);
    const demo::GlFunctions& gl = context.gl();

    Result<std::string> library = glsl({330, false, GlslUniforms::none});
    if (!library) return library.error();
    const std::string main = "#define TEXELS " + std::to_string(texels) + "\n#define FRINGE_TABLE " +
                             (form == FringeForm::table ? "1\n" : "0\n") + fragmentShader;
    Result<GLuint> program = demo::linkProgram(gl, vertexShader, *library + main);
    if (!program) return program.error();
    evaluator.program_ = *program;

    if (form == FringeForm::table) {
        Result<FringeTable> table = FringeTable::create();
        if (!table) return table.error();
        gl.GenTextures(1, &evaluator.fringeTable_);
        gl.BindTexture(GL_TEXTURE_2D, evaluator.fringeTable_);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, FringeTable::width, FringeTable::height, 0, GL_RGBA, GL_FLOAT, table->texels().data());
    }

    gl.GenVertexArrays(1, &evaluator.vertexArray_);
    gl.GenTextures(1, &evaluator.input_);
    makeTexture(gl, evaluator.input_, GL_RGBA32F, side * texels);
    evaluator.outputs_.resize(targets);
    gl.GenTextures(targets, evaluator.outputs_.data());
    gl.GenFramebuffers(1, &evaluator.framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, evaluator.framebuffer_);
    std::vector<GLenum> buffers;
    for (GLuint texture : evaluator.outputs_) {
        makeTexture(gl, texture, GL_RGBA32F, side);
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, texture, 0);
    }
    gl.DrawBuffers(targets, buffers.data());
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return Error{"the driver cannot render to eight float32 targets"};
    }
    return evaluator;
}

Result<std::vector<GpuOutput>> GpuEvaluator::run(const std::vector<GpuInput>& inputs) const
{
    const demo::GlFunctions& gl = *gl_;
    constexpr std::size_t batch = side * side;
    std::vector<float> packed(batch * texels * 4);
    std::vector<float> pixels(batch * 3);
    std::vector<GpuOutput> outputs(inputs.size());

    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.Viewport(0, 0, side, side);
    gl.UseProgram(program_);
    gl.BindVertexArray(vertexArray_);
    if (fringeTable_ != 0) {
        gl.Uniform1i(gl.GetUniformLocation(program_, "fringeTable"), 1);
        gl.ActiveTexture(GL_TEXTURE1);
        gl.BindTexture(GL_TEXTURE_2D, fringeTable_);
        gl.ActiveTexture(GL_TEXTURE0);
    }
    gl.BindTexture(GL_TEXTURE_2D, input_);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    for (std::size_t first = 0; first < inputs.size(); first += batch) {
        const std::size_t count = std::min(batch, inputs.size() - first);
        for (std::size_t i = 0; i < count; ++i) pack(inputs[first + i], packed.data() + i * texels * 4);
        const int rows = static_cast<int>((count + side - 1) / side);
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, side * texels, rows, GL_RGBA, GL_FLOAT, packed.data());
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
        glm::vec3 GpuOutput::*const members[targets] = {&GpuOutput::rho,     &GpuOutput::R,       &GpuOutput::T,     &GpuOutput::phi,
                                                        &GpuOutput::diffuse, &GpuOutput::meanCos, &GpuOutput::shaded, &GpuOutput::lobes};
        for (int target = 0; target < targets; ++target) {
            gl.ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(target));
            gl.ReadPixels(0, 0, side, rows, GL_RGB, GL_FLOAT, pixels.data());
            for (std::size_t i = 0; i < count; ++i) {
                outputs[first + i].*members[target] = {pixels[i * 3], pixels[i * 3 + 1], pixels[i * 3 + 2]};
            }
        }
    }
    if (const GLenum error = gl.GetError()) return Error{"OpenGL error " + std::to_string(error) + " while evaluating"};
    return outputs;
}

}  // namespace nacre::test
