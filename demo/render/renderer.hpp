#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include <nacre/fringe_table.hpp>
#include <nacre/glsl.hpp>
#include <nacre/material.hpp>
#include <nacre/result.hpp>

#include "camera.hpp"
#include "gl/functions.hpp"
#include "gpu_scene.hpp"
#include "image.hpp"
#include "material_programs.hpp"
#include "scene/scene.hpp"
#include "viewpoint.hpp"

namespace nacre::demo {

/// Linear; dark, so that highlights are read.
inline constexpr glm::vec3 background(0.010F, 0.011F, 0.013F);

/// Draws one scene in any material. The context of the functions stays current; they outlive the renderer.
class Renderer {
public:
    static Result<Renderer> create(const GlFunctions& gl, Scene scene);
    ~Renderer();
    Renderer(Renderer&& other) noexcept;
    Renderer& operator=(Renderer&&) = delete;

    /// A picture, off screen. Errors: a size that the driver cannot draw, a material that does not validate.
    Result<Image> render(const Material& material, int width, int height, const Viewpoint& viewpoint = {}) const;

    /// An error where the driver cannot draw a picture of that size.
    Outcome checkSize(int width, int height) const;

    /// Draws into the framebuffer that is bound, within its viewport and scissor, over what is there.
    /// The error is of a material that does not validate.
    Outcome draw(const Material& material, const Viewpoint& viewpoint, const Camera& camera) const;

    /// Another model, or the one there was where it cannot be uploaded.
    Outcome setScene(Scene scene);
    const Scene& scene() const { return scene_.scene(); }

    /// Other texts of the library's files, or those there were where they do not compile.
    Outcome setGlsl(const std::vector<GlslFile>& files);

    const FringeTable& fringeTable() const { return fringeTable_; }

private:
    Renderer(const GlFunctions& gl, MaterialPrograms programs, GpuScene scene, FringeTable table);
    int largestSize() const;

    const GlFunctions* gl_;
    mutable MaterialPrograms programs_;  // links what is first asked for
    GpuScene scene_;
    FringeTable fringeTable_;
    GLuint material_ = 0, fringeTexture_ = 0;
};

}  // namespace nacre::demo
