#include "camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

namespace nacre::demo {
namespace {

constexpr float azimuth = glm::radians(20.0F);
constexpr float elevation = glm::radians(15.0F);
constexpr float fieldOfView = glm::radians(30.0F);  // of the shorter side
constexpr float margin = 1.08F;

template <class Visit>
void forEachPoint(const Scene& scene, Visit visit)
{
    for (const Instance& instance : scene.instances) {
        for (const Vertex& vertex : scene.meshes[instance.mesh].vertices) {
            visit(glm::vec3(instance.objectToWorld * glm::vec4(vertex.position, 1.0F)));
        }
    }
}

}  // namespace

Camera frameScene(const Scene& scene, float aspect)
{
    Camera camera{};
    camera.back = {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
    camera.right = glm::normalize(glm::cross(glm::vec3(0.0F, 1.0F, 0.0F), camera.back));
    camera.up = glm::cross(camera.back, camera.right);
    const glm::mat3 toCamera = glm::transpose(glm::mat3(camera.right, camera.up, camera.back));

    // The middle is that of the extents along the camera's axes: a box along the world's axes can be
    // much larger than what is in it.
    glm::vec3 least(std::numeric_limits<float>::max()), most = -least;
    forEachPoint(scene, [&](glm::vec3 point) {
        least = glm::min(least, toCamera * point);
        most = glm::max(most, toCamera * point);
    });
    const glm::vec3 middle = 0.5F * least + 0.5F * most;

    // The nearest distance from which no point leaves the field of view.
    const float tanShort = std::tan(0.5F * fieldOfView);
    const glm::vec2 tangent(tanShort * std::max(aspect, 1.0F), tanShort * std::max(1.0F / aspect, 1.0F));
    float distance = 0.0F;
    forEachPoint(scene, [&](glm::vec3 point) {
        const glm::vec3 offset = toCamera * point - middle;
        distance = std::max({distance, offset.z + margin * std::fabs(offset.x) / tangent.x, offset.z + margin * std::fabs(offset.y) / tangent.y});
    });
    // A single point has no size: any distance frames it.
    if (!(distance > 0.0F)) distance = 1.0F;
    const float depth = std::max(0.55F * (most.z - least.z), 1e-3F * distance);
    const glm::vec3 centre = glm::transpose(toCamera) * middle;
    camera.eye = centre + camera.back * distance;

    const float nearest = std::max(distance - depth, 1e-3F * distance);
    const glm::vec2 corner = tangent * nearest;
    const glm::mat4 projection = glm::frustum(-corner.x, corner.x, -corner.y, corner.y, nearest, distance + depth);
    camera.worldToClip = projection * glm::lookAt(camera.eye, centre, glm::vec3(0.0F, 1.0F, 0.0F));
    return camera;
}

}  // namespace nacre::demo
