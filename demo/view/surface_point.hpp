#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/camera.hpp"
#include "scene/scene.hpp"

namespace nacre::demo {

/// What a fragment shader is given at a point of the scene, in double precision, in the world.
struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec3 normal;  ///< Towards the viewer's side, as the demo's shader turns it; any length.
    glm::dvec4 tangent;
    glm::dvec3 noisePosition;
};

/// What the camera sees first at a place of its picture, from -1,-1 at the lower left to 1,1: every triangle is tried.
std::optional<SurfacePoint> pointAt(const Scene& scene, const Camera& camera, glm::dvec2 place);

}  // namespace nacre::demo
