#pragma once

#include <glm/vec3.hpp>

#include "scene.hpp"

namespace nacre::demo {

/// Perpendicular to the front of the triangle, as long as twice its area. In double: products of
/// any float coordinates neither overflow nor vanish.
glm::dvec3 doubledArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The direction as a unit vector, or zero when it has none: zero length or not finite.
glm::vec3 unitOrZero(const glm::dvec3& direction);

/// Makes every normal a unit vector. One without a direction becomes the mean of the faces around
/// its vertex, weighted by area, and +Y, up in glTF, where no face has area.
void repairNormals(Mesh& mesh);

}  // namespace nacre::demo
