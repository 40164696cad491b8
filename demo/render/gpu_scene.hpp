#pragma once

#include <vector>

#include <nacre/result.hpp>

#include "gl/functions.hpp"
#include "scene/scene.hpp"

namespace nacre::demo {

/// Where the noise lives: the scene scaled to radius 1 about its middle, since models come in every unit of length.
struct NoiseSpace {
    glm::vec3 centre;
    float radius;
};
NoiseSpace noiseSpace(const Scene& scene);

/// A scene in the driver's memory, freed with it.
class GpuScene {
public:
    static Result<GpuScene> upload(const GlFunctions& gl, Scene scene);
    ~GpuScene();
    GpuScene(GpuScene&& other) noexcept;
    GpuScene& operator=(GpuScene&& other) noexcept;

    /// Draws every triangle with a program in use whose vertex stage is meshVertexShader.
    void draw(GLuint program) const;
    const Scene& scene() const { return scene_; }

private:
    struct Mesh {
        GLuint vertexArray = 0, vertices = 0, indices = 0;
        GLsizei count = 0;
    };
    explicit GpuScene(const GlFunctions& gl) : gl_(&gl) {}

    const GlFunctions* gl_;
    std::vector<Mesh> meshes_;
    Scene scene_;
};

}  // namespace nacre::demo
