#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace nacre::demo {

/// Where the picture is taken from.
struct Camera {
    glm::vec3 eye;
    glm::vec3 right, up, back;  ///< Unit axes of the camera in the world.
    glm::mat4 worldToClip;
};

/// Frames all of the scene, seen from the front, 20 degrees to the right and 15 above.
/// aspect: width over height.
Camera frameScene(const Scene& scene, float aspect);

}  // namespace nacre::demo
