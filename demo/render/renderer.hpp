#pragma once

#include <array>
#include <vector>

#include <nacre/material.hpp>
#include <nacre/result.hpp>

#include "gl/context.hpp"
#include "image.hpp"
#include "scene/scene.hpp"

namespace nacre::demo {

/// Draws one scene off screen in any material. The context stays current and outlives the renderer.
class Renderer {
public:
    static Result<Renderer> create(const Context& context, Scene scene);
    ~Renderer();
    Renderer(Renderer&& other) noexcept;
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Errors: a size that the driver cannot draw, a material that does not validate.
    Result<Image> render(const Material& material, int width, int height) const;

    /// An error where the driver cannot draw a picture of that size.
    Outcome checkSize(int width, int height) const;

private:
    struct Mesh {
        GLuint vertexArray = 0, vertices = 0, indices = 0;
        GLsizei count = 0;
    };
    explicit Renderer(const GlFunctions& gl) : gl_(&gl) {}
    int largestSize() const;
    void draw(GLuint program, const struct Camera& camera) const;

    const GlFunctions* gl_;
    std::array<GLuint, 2> programs_{};  // by Quality
    GLuint material_ = 0, fringeTable_ = 0;
    std::vector<Mesh> meshes_;
    Scene scene_;
};

}  // namespace nacre::demo
