#pragma once

#include <glm/vec3.hpp>

namespace nacre::demo {

/// Where a scene is seen and lit from. The default frames all of it, from the front, 20 degrees to the right
/// and 15 above.
struct Viewpoint {
    float azimuthDegrees = 20.0F;    ///< To the right of the front.
    float elevationDegrees = 15.0F;  ///< Above the horizon, -89 to 89.
    float zoom = 1.0F;               ///< 2: from half the distance that frames all.
    glm::vec3 target{0.0F};          ///< What the camera turns about: from the scene's middle, in scene radii.
    glm::vec3 light{-0.45F, 0.65F, 0.75F};  ///< To the key light along the camera's axes: right, up, to the viewer. Any length but 0.
};

}  // namespace nacre::demo
