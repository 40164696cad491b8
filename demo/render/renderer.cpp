#include "renderer.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <nacre/block.hpp>
#include <nacre/glsl.hpp>

#include "camera.hpp"
#include "gl/fringe_texture.hpp"
#include "gl/program.hpp"
#include "shaders.hpp"

namespace nacre::demo {
namespace {

constexpr glm::vec3 background(0.010F, 0.011F, 0.013F);  // linear; dark, so that highlights are read

// Directional lights in the camera's axes (right, up, back), so that any model is lit the same way: key
// from the upper left, a weaker fill from the right, a rim from behind.
struct Light {
    glm::vec3 direction;
    float radiance;
};
constexpr std::array<Light, 4> lights{{{{-0.45F, 0.65F, 0.75F}, 0.55F},
                                       {{0.85F, 0.1F, 0.6F}, 0.25F},
                                       {{0.25F, 0.8F, -0.5F}, 0.2F},
                                       {{-0.4F, -0.8F, 0.45F}, 0.1F}}};

Result<GLuint> linkFor(const GlFunctions& gl, Quality quality)
{
    Result<std::string> library = glsl();
    if (!library) return library.error();
    const std::string define = "#define QUALITY_PHYSICAL " + std::to_string(quality == Quality::physical ? 1 : 0) + '\n';
    Result<GLuint> program = linkProgram(gl, meshVertexShader, *library + define + meshFragmentShader);
    if (program) gl.UniformBlockBinding(*program, gl.GetUniformBlockIndex(*program, "nacre_Block"), 0);
    return program;
}

// A framebuffer of one float colour and one depth buffer, freed with it.
class Target {
public:
    Target(const GlFunctions& gl, int width, int height) : gl_(gl)
    {
        gl.GenFramebuffers(1, &framebuffer_);
        gl.GenTextures(1, &colour_);
        gl.GenTextures(1, &depth_);
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl.BindTexture(GL_TEXTURE_2D, colour_);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
        gl.BindTexture(GL_TEXTURE_2D, depth_);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    }
    ~Target()
    {
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteTextures(1, &colour_);
        gl_.DeleteTextures(1, &depth_);
    }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

private:
    const GlFunctions& gl_;
    GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
};

}  // namespace

Result<Renderer> Renderer::create(const Context& context, Scene scene)
{
    const GlFunctions& gl = context.gl();
    Renderer renderer(gl);
    for (const Quality quality : {Quality::paper, Quality::physical}) {
        Result<GLuint> program = linkFor(gl, quality);
        if (!program) return program.error();
        renderer.programs_[static_cast<std::size_t>(quality)] = *program;
    }
    Result<FringeTable> table = FringeTable::create();
    if (!table) return table.error();
    renderer.fringeTable_ = makeFringeTexture(gl, *table);
    gl.GenBuffers(1, &renderer.material_);

    for (const nacre::demo::Mesh& source : scene.meshes) {
        Mesh mesh;
        mesh.count = static_cast<GLsizei>(source.indices.size());
        gl.GenVertexArrays(1, &mesh.vertexArray);
        gl.GenBuffers(1, &mesh.vertices);
        gl.GenBuffers(1, &mesh.indices);
        gl.BindVertexArray(mesh.vertexArray);
        gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(source.vertices.size() * sizeof(Vertex)), source.vertices.data(),
                      GL_STATIC_DRAW);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(source.indices.size() * sizeof(std::uint32_t)),
                      source.indices.data(), GL_STATIC_DRAW);
        const auto attribute = [&](GLuint location, GLint size, std::size_t offset) {
            gl.EnableVertexAttribArray(location);
            gl.VertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
        };
        attribute(0, 3, offsetof(Vertex, position));
        attribute(1, 3, offsetof(Vertex, normal));
        attribute(2, 4, offsetof(Vertex, tangent));
        renderer.meshes_.push_back(mesh);
    }
    if (const GLenum error = gl.GetError()) return Error{"OpenGL error " + std::to_string(error) + " while uploading the model"};
    renderer.scene_ = std::move(scene);
    return renderer;
}

Renderer::Renderer(Renderer&& other) noexcept
    : gl_(other.gl_), programs_(std::exchange(other.programs_, {})), material_(std::exchange(other.material_, 0U)),
      fringeTable_(std::exchange(other.fringeTable_, 0U)),
      meshes_(std::move(other.meshes_)), scene_(std::move(other.scene_))
{
    other.meshes_.clear();
}

Renderer::~Renderer()
{
    for (const Mesh& mesh : meshes_) {
        gl_->DeleteVertexArrays(1, &mesh.vertexArray);
        gl_->DeleteBuffers(1, &mesh.vertices);
        gl_->DeleteBuffers(1, &mesh.indices);
    }
    if (material_) gl_->DeleteBuffers(1, &material_);
    if (fringeTable_) gl_->DeleteTextures(1, &fringeTable_);
    for (const GLuint program : programs_) {
        if (program) gl_->DeleteProgram(program);
    }
}

int Renderer::largestSize() const
{
    GLint texture = 0;
    std::array<GLint, 2> viewport{};
    gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    gl_->GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    return std::min({texture, viewport[0], viewport[1]});
}

Outcome Renderer::checkSize(int width, int height) const
{
    const int largest = largestSize();
    if (width >= 1 && height >= 1 && std::max(width, height) <= largest) return std::monostate{};
    return Error{"expected a size from 1x1 to " + std::to_string(largest) + 'x' + std::to_string(largest) + ", got " +
                 std::to_string(width) + 'x' + std::to_string(height)};
}

Result<Image> Renderer::render(const Material& material, int width, int height) const
{
    const GlFunctions& gl = *gl_;
    if (Outcome drawable = checkSize(width, height); !drawable) return drawable.error();
    Result<Block> block = pack(material);
    if (!block) return block.error();

    // Nine samples per pixel while the driver's limits and 1 GiB of samples allow: highlights of
    // narrow lobes need them as much as edges do, and multisampling would smooth edges only.
    const int largest = largestSize();
    int samples = 3;
    const auto exceeds = [&](int n) {
        return std::max(width, height) * n > largest || 16.0 * width * height * n * n > 1024.0 * 1024.0 * 1024.0;
    };
    while (samples > 1 && exceeds(samples)) --samples;
    Image fine{width * samples, height * samples, {}};

    const Target target(gl, fine.width, fine.height);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return Error{"the driver cannot draw " + std::to_string(width) + 'x' + std::to_string(height) + " in float"};
    }
    gl.BindBuffer(GL_UNIFORM_BUFFER, material_);
    gl.BufferData(GL_UNIFORM_BUFFER, sizeof(Block), &*block, GL_DYNAMIC_DRAW);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, material_);
    gl.Viewport(0, 0, fine.width, fine.height);
    gl.ClearColor(background.r, background.g, background.b, 1.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_DEPTH_TEST);
    gl.BindTexture(GL_TEXTURE_2D, fringeTable_);
    draw(programs_[static_cast<std::size_t>(material.quality)], frameScene(scene_, static_cast<float>(width) / static_cast<float>(height)));

    const std::size_t row = static_cast<std::size_t>(fine.width) * 3;
    fine.pixels.resize(row * static_cast<std::size_t>(fine.height));
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.ReadPixels(0, 0, fine.width, fine.height, GL_RGB, GL_FLOAT, fine.pixels.data());
    if (const GLenum error = gl.GetError()) return Error{"OpenGL error " + std::to_string(error) + " while drawing"};
    // OpenGL's first row is the lowest.
    for (std::size_t low = 0, high = static_cast<std::size_t>(fine.height) - 1; low < high; ++low, --high) {
        std::swap_ranges(fine.pixels.begin() + static_cast<std::ptrdiff_t>(low * row),
                         fine.pixels.begin() + static_cast<std::ptrdiff_t>((low + 1) * row),
                         fine.pixels.begin() + static_cast<std::ptrdiff_t>(high * row));
    }
    return shrink(fine, samples);
}

void Renderer::draw(GLuint program, const Camera& camera) const
{
    const GlFunctions& gl = *gl_;
    const auto at = [&](const char* name) { return gl.GetUniformLocation(program, name); };
    const glm::vec3 centre = 0.5F * (scene_.bounds.least + scene_.bounds.most);
    const float radius = 0.5F * glm::length(scene_.bounds.most - scene_.bounds.least);

    gl.UseProgram(program);
    gl.UniformMatrix4fv(at("worldToClip"), 1, GL_FALSE, glm::value_ptr(camera.worldToClip));
    gl.Uniform3fv(at("sceneCentre"), 1, glm::value_ptr(centre));
    gl.Uniform1f(at("sceneRadius"), radius > 0.0F ? radius : 1.0F);
    gl.Uniform3fv(at("eye"), 1, glm::value_ptr(camera.eye));
    const glm::mat3 axes(camera.right, camera.up, camera.back);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const std::string index = '[' + std::to_string(i) + ']';
        const glm::vec3 direction = glm::normalize(axes * lights[i].direction);
        gl.Uniform3fv(at(("lightDirection" + index).c_str()), 1, glm::value_ptr(direction));
        gl.Uniform1f(at(("lightRadiance" + index).c_str()), lights[i].radiance);
    }
    const GLint objectToWorld = at("objectToWorld"), normalToWorld = at("normalToWorld");
    for (const Instance& instance : scene_.instances) {
        const Mesh& mesh = meshes_[instance.mesh];
        const glm::mat3 linear(instance.objectToWorld);
        gl.UniformMatrix4fv(objectToWorld, 1, GL_FALSE, glm::value_ptr(instance.objectToWorld));
        gl.UniformMatrix3fv(normalToWorld, 1, GL_FALSE, glm::value_ptr(glm::inverseTranspose(linear)));
        gl.FrontFace(isMirrored(instance) ? GL_CW : GL_CCW);
        gl.BindVertexArray(mesh.vertexArray);
        gl.DrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
    }
}

}  // namespace nacre::demo
