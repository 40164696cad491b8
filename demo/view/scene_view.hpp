#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <nacre/material.hpp>
#include <nacre/result.hpp>

#include "picture_size.hpp"
#include "render/float_target.hpp"
#include "render/renderer.hpp"

namespace nacre::demo {

/// What SceneView draws: one material, or two side by side.
struct ScenePicture {
    std::array<Material, 2> materials;
    float divider = 0.0F;  ///< Over the width; materials[0] to its left, materials[1] to its right.
    Viewpoint viewpoint;
    Size size;
};

/// The scene's part of the window: drawn at once with the samples that the driver is fast enough for, then, at rest,
/// in bands with nine samples a pixel, as the pictures of Renderer::render are.
class SceneView {
public:
    static Result<std::unique_ptr<SceneView>> create(const GlFunctions& gl);
    ~SceneView();
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    /// Draws the picture quickly.
    Outcome draw(const Renderer& renderer, const ScenePicture& picture);
    /// The renderer's model is another one: it is framed anew.
    void sceneChanged() { framing_.reset(); }
    /// Whether there is something left to refine.
    bool isFine() const { return shownSamples_ >= restSamples_; }
    /// A band of the finer picture, which is shown when the last one is done.
    Outcome refine(const Renderer& renderer);

    /// Copies what is shown to the window's framebuffer, whose lower left corner the picture's goes to.
    void present(int left, int bottom) const;
    /// What is shown, sRGB, the lowest row first.
    GLuint texture() const { return shown_; }
    Size size() const { return picture_.size; }
    const ScenePicture& picture() const { return picture_; }
    const Camera& camera() const { return camera_; }
    const Framing& framing() const { return *framing_; }  ///< Once something was drawn.

    /// A sample in the middle of a pixel or next to it: its linear colour, and where it was taken, from the lower left
    /// corner in pixels.
    struct Sample {
        glm::vec3 colour;
        glm::dvec2 place;
    };
    Sample sample(int x, int y) const;
    /// The pixel's linear colour, the mean of its samples.
    glm::vec3 mean(int x, int y) const;

    double quickMilliseconds() const { return quickMilliseconds_; }  ///< Of the last draw().
    int coarse() const { return coarse_; }                           ///< Pixels per sample and axis in the next draw().
    int samples() const { return shownSamples_; }                    ///< Per pixel and axis; 0: fewer than one.
    long draws() const { return draws_; }

private:
    explicit SceneView(const GlFunctions& gl) : gl_(gl) {}
    struct Layout {
        int samples, coarse;  // texels per pixel and axis, or pixels per texel
    };
    void keepPace();
    int finest() const;
    Size texels(Layout layout) const;
    Outcome drawHalves(const Renderer& renderer, const FloatTarget& target, int fromRow, int toRow) const;
    void resolve();
    std::vector<float> read(int x, int y, int width, int height) const;

    const GlFunctions& gl_;
    GLuint program_ = 0, vertexArray_ = 0, shown_ = 0, framebuffer_ = 0;
    ScenePicture picture_;
    std::optional<Framing> framing_;
    float framedAspect_ = 0.0F;
    Camera camera_{};
    std::unique_ptr<FloatTarget> target_, fineTarget_;
    Layout layout_{1, 1}, fineLayout_{1, 1};
    int shownSamples_ = 0, restSamples_ = 0, fineRow_ = 0;
    int coarse_ = 1, bandRows_ = 0;
    double quickMilliseconds_ = 0.0;
    long draws_ = 0;
};

}  // namespace nacre::demo
