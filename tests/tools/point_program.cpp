#include "point_program.hpp"

#include <nacre/glsl.hpp>

#include "gl/program.hpp"
#include "naive_forms.hpp"

namespace nacre::test {
namespace {

// A draw is a picture of side × side pixels. Inputs lie in textures of as many columns per pixel as an
// input has texels: 256 × 13 columns are within every driver's limits.
constexpr int side = 256;
static_assert(PointProgram::most == side * side);
constexpr int blockTexels = sizeof(Block) / 16;
constexpr int pointTexels = sizeof(GpuPoint) / 16;

const char* const vertexShader = R"(#version 330 core
void main()  // one triangle that covers the picture
{
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

const char* const fetchFunctions = R"(
uniform sampler2D materials;
uniform sampler2D points;

vec4 pointTexel(int index)
{
    return texelFetch(points, ivec2(int(gl_FragCoord.x) * POINT_TEXELS + index, int(gl_FragCoord.y)), 0);
}

vec4 materialTexel(int material, int index)
{
    return texelFetch(materials, ivec2(material % SIDE * BLOCK_TEXELS + index, material / SIDE), 0);
}
)";

// The block's integers for noise and lower normal are not needed: directions and thickness are inputs. Members
// that the features leave out are not there to be set; those of a constant thickness are not meant here.
const char* const materialOfThePoint = R"(
nacre_Material pointMaterial()
{
    int material = int(pointTexel(1).w);
    nacre_Material m;
    vec4 first = materialTexel(material, 0), second = materialTexel(material, 1), third = materialTexel(material, 2);
    m.upperExponent = first.w;
    m.etaSquared = nacre_Channels(second.xyz);
    m.lowerExponent = second.w;
    m.oneMinusEtaSquared = nacre_Channels(third.xyz);
    m.specularWeight = third.w;
    m.diffuseWeight = materialTexel(material, 3).w;
    m.diffuseFringe = nacre_Channels(materialTexel(material, 6).xyz);
    m.eta = nacre_Channels(first.xyz);
#if NACRE_PAPER
    m.normalReflectance = nacre_Channels(materialTexel(material, 3).xyz);
    m.cyclesPerUm = materialTexel(material, 4).xyz;
    m.cyclesPerUmTail = materialTexel(material, 5).xyz;
#endif
#if NACRE_PHYSICAL
    m.index = nacre_Channels(materialTexel(material, 9).xyz);
    m.upperScale = materialTexel(material, 9).w;
    m.substrateReal = materialTexel(material, 10).xyz;
    m.lowerScale = materialTexel(material, 10).w;
    m.substrateImaginary = materialTexel(material, 11).xyz;
    m.diffuseAlbedo = materialTexel(material, 12).xyz;
    int choices = int(pointTexel(2).w);
    m.quality = choices % 4;
    m.substrate = choices / 4 % 4;
    m.lobes = choices / 16;
#endif
    return m;
}
)";

const char* const materialOfTheBlock = R"(
nacre_Material pointMaterial()
{
    return nacre_materialFromUniforms();
}
)";

const char* const inputFunctions = R"(
nacre_Surface pointSurface()
{
    nacre_Surface s;
    s.upperNormal = pointTexel(2).xyz;
    s.lowerNormal = pointTexel(3).xyz;
    s.thicknessUm = pointTexel(0).w;
    return s;
}

vec3 pointLight() { return pointTexel(0).xyz; }
vec3 pointView() { return pointTexel(1).xyz; }
)";

std::string define(const char* name, int value)
{
    return std::string("#define ") + name + ' ' + std::to_string(value) + '\n';
}

void makeTexture(const demo::GlFunctions& gl, GLuint texture, int width)
{
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, side, 0, GL_RGBA, GL_FLOAT, nullptr);
}

// Items fill rows of `side`, the last one perhaps in part: copy(row, rows, columns, first item).
template <class Copy>
void forRows(std::size_t count, Copy copy)
{
    const int whole = static_cast<int>(count / side), rest = static_cast<int>(count % side);
    if (whole > 0) copy(0, whole, side, std::size_t{0});
    if (rest > 0) copy(whole, 1, rest, count - static_cast<std::size_t>(rest));
}

template <class Item>
void upload(const demo::GlFunctions& gl, GLenum unit, GLuint texture, const Item* items, std::size_t count)
{
    gl.ActiveTexture(unit);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    forRows(count, [&](int row, int rows, int columns, std::size_t first) {
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, row, columns * static_cast<int>(sizeof(Item) / 16), rows, GL_RGBA, GL_FLOAT,
                         items + first);
    });
}

}  // namespace

Result<PointProgram> PointProgram::create(const demo::Context& context, const std::string& main, int targets, const Options& options)
{
    PointProgram points(context);
    const demo::GlFunctions& gl = context.gl();

    const GlslUniforms uniforms = options.readsTheBlock ? GlslUniforms::block : GlslUniforms::none;
    Result<std::string> library = glsl({330, false, uniforms, options.features});
    if (library && !options.naiveForm.empty()) library = withNaiveForm(*library, options.naiveForm);
    if (!library) return library.error();
    const std::string sizes = define("SIDE", side) + define("BLOCK_TEXELS", blockTexels) + define("POINT_TEXELS", pointTexels);
    const std::string material = options.readsTheBlock ? materialOfTheBlock : materialOfThePoint;
    Result<GLuint> program = demo::linkProgram(gl, vertexShader, *library + sizes + fetchFunctions + material + inputFunctions + main);
    if (!program) return program.error();
    points.program_ = *program;
    gl.UseProgram(points.program_);
    gl.Uniform1i(gl.GetUniformLocation(points.program_, "materials"), 0);
    gl.Uniform1i(gl.GetUniformLocation(points.program_, "points"), 1);

    if (options.readsTheBlock) {
        gl.GenBuffers(1, &points.block_);
        gl.UniformBlockBinding(points.program_, gl.GetUniformBlockIndex(points.program_, "nacre_Block"), 0);
    }
    gl.GenVertexArrays(1, &points.vertexArray_);
    gl.GenTextures(1, &points.materials_);
    makeTexture(gl, points.materials_, side * blockTexels);
    gl.GenTextures(1, &points.points_);
    makeTexture(gl, points.points_, side * pointTexels);
    points.outputs_.resize(static_cast<std::size_t>(targets));
    gl.GenTextures(targets, points.outputs_.data());
    gl.GenFramebuffers(1, &points.framebuffer_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, points.framebuffer_);
    std::vector<GLenum> buffers;
    for (GLuint texture : points.outputs_) {
        makeTexture(gl, texture, side);
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, texture, 0);
    }
    gl.DrawBuffers(targets, buffers.data());
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return Error{"the driver cannot render to " + std::to_string(targets) + " float32 targets"};
    }
    return points;
}

void PointProgram::setMaterials(const Block* blocks, std::size_t count) const
{
    upload(*gl_, GL_TEXTURE0, materials_, blocks, count);
}

void PointProgram::setBlock(const Block& block) const
{
    gl_->BindBuffer(GL_UNIFORM_BUFFER, block_);
    gl_->BufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
    gl_->BindBufferBase(GL_UNIFORM_BUFFER, 0, block_);
}

void PointProgram::destroy() const
{
    gl_->DeleteProgram(program_);
    gl_->DeleteVertexArrays(1, &vertexArray_);
    gl_->DeleteFramebuffers(1, &framebuffer_);
    gl_->DeleteTextures(1, &materials_);
    gl_->DeleteTextures(1, &points_);
    gl_->DeleteTextures(static_cast<GLsizei>(outputs_.size()), outputs_.data());
    if (block_ != 0) gl_->DeleteBuffers(1, &block_);
}

void PointProgram::bindTexture(const char* sampler, int unit, GLuint texture) const
{
    gl_->UseProgram(program_);
    gl_->Uniform1i(gl_->GetUniformLocation(program_, sampler), unit);
    gl_->ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_->BindTexture(GL_TEXTURE_2D, texture);
    gl_->ActiveTexture(GL_TEXTURE0);
}

void PointProgram::draw(const GpuPoint* points, std::size_t count) const
{
    const demo::GlFunctions& gl = *gl_;
    upload(gl, GL_TEXTURE1, points_, points, count);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, materials_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.Viewport(0, 0, side, static_cast<int>((count + side - 1) / side));
    gl.UseProgram(program_);
    gl.BindVertexArray(vertexArray_);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void PointProgram::read(int target, glm::vec4* pixels, std::size_t count) const
{
    gl_->ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(target));
    forRows(count, [&](int row, int rows, int columns, std::size_t first) {
        gl_->ReadPixels(0, row, columns, rows, GL_RGBA, GL_FLOAT, pixels + first);
    });
}

Outcome PointProgram::check() const
{
    if (const GLenum error = gl_->GetError()) return Error{"OpenGL error " + std::to_string(error) + " while evaluating"};
    return std::monostate{};
}

}  // namespace nacre::test
