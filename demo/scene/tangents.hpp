#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "scene.hpp"

namespace nacre::demo {

/// Makes every tangent a unit vector perpendicular to its vertex's normal, with w = 1 or -1. Usable
/// tangents keep their direction. Others follow the texture coordinates, one for each vertex or
/// none at all; where those tell nothing, a frame that is smooth over the sphere of normals but for
/// straight down. Expects unit normals.
void completeTangents(Mesh& mesh, const std::vector<glm::vec2>& texCoords);

}  // namespace nacre::demo
