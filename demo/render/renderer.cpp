#include "renderer.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include <nacre/block.hpp>

#include "float_target.hpp"
#include "gl/fringe_texture.hpp"
#include "lights.hpp"

namespace nacre::demo {

Result<Renderer> Renderer::create(const GlFunctions& gl, Scene scene)
{
    Result<MaterialPrograms> programs = MaterialPrograms::create(gl);
    if (!programs) return programs.error();
    Result<FringeTable> table = FringeTable::create();
    if (!table) return table.error();
    Result<GpuScene> uploaded = GpuScene::upload(gl, std::move(scene));
    if (!uploaded) return uploaded.error();
    return Renderer(gl, *std::move(programs), *std::move(uploaded), *std::move(table));
}

Renderer::Renderer(const GlFunctions& gl, MaterialPrograms programs, GpuScene scene, FringeTable table)
    : gl_(&gl), programs_(std::move(programs)), scene_(std::move(scene)), fringeTable_(std::move(table)),
      fringeTexture_(makeFringeTexture(gl, fringeTable_))
{
    gl.GenBuffers(1, &material_);
}

Renderer::Renderer(Renderer&& other) noexcept
    : gl_(other.gl_), programs_(std::move(other.programs_)), scene_(std::move(other.scene_)),
      fringeTable_(std::move(other.fringeTable_)), material_(std::exchange(other.material_, 0U)),
      fringeTexture_(std::exchange(other.fringeTexture_, 0U))
{
}

Renderer::~Renderer()
{
    if (material_) gl_->DeleteBuffers(1, &material_);
    if (fringeTexture_) gl_->DeleteTextures(1, &fringeTexture_);
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

Result<Image> Renderer::render(const Material& material, int width, int height, const Viewpoint& viewpoint) const
{
    const GlFunctions& gl = *gl_;
    if (Outcome drawable = checkSize(width, height); !drawable) return drawable.error();

    // Nine samples per pixel while the driver's limits and 1 GiB of samples allow: highlights of
    // narrow lobes need them as much as edges do, and multisampling would smooth edges only.
    const int largest = largestSize();
    int samples = 3;
    const auto exceeds = [&](int n) {
        return std::max(width, height) * n > largest || 16.0 * width * height * n * n > 1024.0 * 1024.0 * 1024.0;
    };
    while (samples > 1 && exceeds(samples)) --samples;
    Image fine{width * samples, height * samples, {}};

    const FloatTarget target(gl, fine.width, fine.height);
    if (!target.isComplete()) {
        return Error{"the driver cannot draw " + std::to_string(width) + 'x' + std::to_string(height) + " in float"};
    }
    target.use();
    gl.ClearColor(background.r, background.g, background.b, 1.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const Framing framing = frameScene(scene(), static_cast<float>(width) / static_cast<float>(height));
    if (Outcome drawn = draw(material, viewpoint, placeCamera(framing, viewpoint)); !drawn) return drawn.error();

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

Outcome Renderer::draw(const Material& material, const Viewpoint& viewpoint, const Camera& camera) const
{
    const GlFunctions& gl = *gl_;
    Result<Block> block = pack(material, &fringeTable_);
    if (!block) return block.error();
    Result<GLuint> linked = programs_.of(material);
    if (!linked) return linked.error();
    gl.BindBuffer(GL_UNIFORM_BUFFER, material_);
    gl.BufferData(GL_UNIFORM_BUFFER, sizeof(Block), &*block, GL_DYNAMIC_DRAW);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, material_);
    gl.Enable(GL_DEPTH_TEST);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, fringeTexture_);

    const GLuint program = *linked;
    const auto at = [&](const std::string& name) { return gl.GetUniformLocation(program, name.c_str()); };
    gl.UseProgram(program);
    gl.UniformMatrix4fv(at("worldToClip"), 1, GL_FALSE, glm::value_ptr(camera.worldToClip));
    gl.Uniform3fv(at("eye"), 1, glm::value_ptr(camera.eye));
    const auto lights = lightsOf(viewpoint, camera);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const std::string index = '[' + std::to_string(i) + ']';
        gl.Uniform3fv(at("lightDirection" + index), 1, glm::value_ptr(lights[i].direction));
        gl.Uniform1f(at("lightRadiance" + index), lights[i].radiance);
    }
    scene_.draw(program);
    return std::monostate{};
}

Outcome Renderer::setScene(Scene scene)
{
    Result<GpuScene> uploaded = GpuScene::upload(*gl_, std::move(scene));
    if (!uploaded) return uploaded.error();
    scene_ = *std::move(uploaded);
    return std::monostate{};
}

Outcome Renderer::setGlsl(const std::vector<GlslFile>& files)
{
    Result<MaterialPrograms> programs = MaterialPrograms::create(*gl_, files);
    if (!programs) return programs.error();
    programs_ = *std::move(programs);
    return std::monostate{};
}

}  // namespace nacre::demo
