#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"
#include "viewpoint.hpp"

namespace nacre::demo {

/// Where the picture is taken from.
struct Camera {
    glm::vec3 eye;
    glm::vec3 right, up, back;  ///< Unit axes of the camera in the world.
    glm::mat4 worldToClip;
};

/// How all of a scene is framed from the default direction: what a viewpoint is relative to.
struct Framing {
    glm::vec3 centre;    ///< In the middle of the picture.
    float distance;      ///< From which no point leaves the field of view.
    float depth;         ///< The scene lies within this of the centre, along the default direction.
    float radius;        ///< And within this in every direction.
    glm::vec2 tangent;   ///< Of half the field of view, across and up.
};

/// aspect: width over height.
Framing frameScene(const Scene& scene, float aspect);

Camera placeCamera(const Framing& framing, const Viewpoint& viewpoint);

}  // namespace nacre::demo
