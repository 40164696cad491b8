#pragma once

#include <glm/vec2.hpp>

#include "render/camera.hpp"
#include "render/viewpoint.hpp"

namespace nacre::demo {

// Each turns a movement of the mouse, in shares of the picture's shorter side (right and down positive), into a viewpoint.

void orbit(Viewpoint& viewpoint, glm::vec2 movement);
/// What is under the mouse stays under it, at the target's distance.
void pan(Viewpoint& viewpoint, glm::vec2 movement, const Framing& framing);
void zoom(Viewpoint& viewpoint, float steps);
/// The key light goes with the mouse, over a sphere around the scene.
void dragLight(Viewpoint& viewpoint, glm::vec2 movement);

}  // namespace nacre::demo
