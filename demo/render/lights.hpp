#pragma once

#include <array>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "camera.hpp"
#include "viewpoint.hpp"

namespace nacre::demo {

struct Light {
    glm::vec3 direction;  ///< To the light, unit, in the world.
    float radiance;
};

/// Directional lights that turn with the camera, so that any model is lit the same way: key from the upper left,
/// a weaker fill from the right, a rim from behind, and little from below. The key light comes first.
inline std::array<Light, 4> lightsOf(const Viewpoint& viewpoint, const Camera& camera)
{
    const glm::mat3 axes(camera.right, camera.up, camera.back);
    std::array<Light, 4> lights{{{viewpoint.light, 0.55F},
                                 {{0.85F, 0.1F, 0.6F}, 0.25F},
                                 {{0.25F, 0.8F, -0.5F}, 0.2F},
                                 {{-0.4F, -0.8F, 0.45F}, 0.1F}}};
    for (Light& light : lights) light.direction = glm::normalize(axes * light.direction);
    return lights;
}

}  // namespace nacre::demo
