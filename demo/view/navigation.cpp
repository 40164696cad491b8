#include "navigation.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace nacre::demo {
namespace {

constexpr float degreesPerSide = 180.0F;  // half a turn across the picture
constexpr float zoomPerStep = 1.15F;

// Short numbers: what is exported is read by people.
float shortened(float value, float unit)
{
    return std::round(value / unit) * unit;
}

float turned(float degrees)
{
    return std::remainder(degrees, 360.0F);
}

}  // namespace

void orbit(Viewpoint& viewpoint, glm::vec2 movement)
{
    viewpoint.azimuthDegrees = turned(shortened(viewpoint.azimuthDegrees - degreesPerSide * movement.x, 0.01F));
    viewpoint.elevationDegrees = std::clamp(shortened(viewpoint.elevationDegrees + degreesPerSide * movement.y, 0.01F), -89.0F, 89.0F);
}

void pan(Viewpoint& viewpoint, glm::vec2 movement, const Framing& framing)
{
    const Camera camera = placeCamera(framing, viewpoint);
    const float side = 2.0F * std::min(framing.tangent.x, framing.tangent.y) * framing.distance / viewpoint.zoom;
    const glm::vec3 target = viewpoint.target + side / framing.radius * (camera.up * movement.y - camera.right * movement.x);
    for (int i = 0; i < 3; ++i) viewpoint.target[i] = std::clamp(shortened(target[i], 1e-4F), -100.0F, 100.0F);
}

void zoom(Viewpoint& viewpoint, float steps)
{
    viewpoint.zoom = std::clamp(shortened(viewpoint.zoom * std::pow(zoomPerStep, steps), 1e-3F), 0.05F, 100.0F);
}

void dragLight(Viewpoint& viewpoint, glm::vec2 movement)
{
    const glm::vec3 light = glm::normalize(viewpoint.light);
    const float azimuth = std::atan2(light.x, light.z) + glm::radians(degreesPerSide) * movement.x;
    const float elevation = std::clamp(std::asin(std::clamp(light.y, -1.0F, 1.0F)) - glm::radians(degreesPerSide) * movement.y,
                                       glm::radians(-89.0F), glm::radians(89.0F));
    viewpoint.light = {shortened(std::sin(azimuth) * std::cos(elevation), 1e-4F), shortened(std::sin(elevation), 1e-4F),
                       shortened(std::cos(azimuth) * std::cos(elevation), 1e-4F)};
}

}  // namespace nacre::demo
