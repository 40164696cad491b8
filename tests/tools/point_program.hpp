#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <nacre/block.hpp>
#include <nacre/features.hpp>
#include <nacre/result.hpp>

#include "gl/context.hpp"

namespace nacre::test {

/// What one evaluation gets beside its material, as it lies in the texture: four texels.
struct GpuPoint {
    glm::vec3 light;
    float thicknessUm;
    glm::vec3 view;
    float material;  ///< Its index among the materials; exact, there are fewer than 2^24.
    glm::vec3 upperNormal;
    float choices;  ///< choicesOf its material's block; 0: quality `paper`.
    glm::vec3 lowerNormal;
    float unused;
};
static_assert(sizeof(GpuPoint) == 64, "four texels of four floats");

/// The block's enumerations as one float: their bits as they lie in the block are no floats that a texture keeps.
inline float choicesOf(const Block& block)
{
    return static_cast<float>(block.quality + 4 * block.substrate + 16 * block.lobes);
}

/// A fragment program that runs once per point with float32 targets. Its source is the library's GLSL,
/// unmodified (but for a naive form that is asked for), then functions that fetch the pixel's inputs, then `main`:
///
///     nacre_Material pointMaterial();  // but for thickness, noise and lower normal, which the point states
///     nacre_Surface pointSurface();
///     vec3 pointLight();
///     vec3 pointView();
class PointProgram {
public:
    /// Most points, and most materials, of one draw().
    static constexpr std::size_t most = 65536;

    /// How the library's text is assembled.
    struct Options {
        std::string naiveForm;       ///< See naive_forms.hpp; empty: none.
        Features features{};
        bool readsTheBlock = false;  ///< pointMaterial() is nacre_materialFromUniforms(), the same for all points: setBlock.
    };

    /// targets: how many vec4 `main` writes, from location 0 on.
    static Result<PointProgram> create(const demo::Context& context, const std::string& main, int targets, const Options& options);

    void setMaterials(const Block* blocks, std::size_t count) const;
    void setBlock(const Block& block) const;
    /// A texture of the caller's for a sampler in `main`, at a unit from 2 on.
    void bindTexture(const char* sampler, int unit, GLuint texture) const;
    void draw(const GpuPoint* points, std::size_t count) const;
    /// The first `count` pixels of the last draw.
    void read(int target, glm::vec4* pixels, std::size_t count) const;
    /// Frees what the driver holds of it; most programs live as long as their test.
    void destroy() const;
    /// Whether the driver reported an error since the last call.
    Outcome check() const;

private:
    explicit PointProgram(const demo::Context& context) : gl_(&context.gl()) {}
    const demo::GlFunctions* gl_;
    GLuint program_ = 0, vertexArray_ = 0, framebuffer_ = 0, materials_ = 0, points_ = 0, block_ = 0;
    std::vector<GLuint> outputs_;
};

}  // namespace nacre::test
