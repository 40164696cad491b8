#include "camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

namespace nacre::demo {
namespace {

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

// Right, up and back of a camera that looks from there.
glm::mat3 axes(const Viewpoint& viewpoint)
{
    const float azimuth = glm::radians(viewpoint.azimuthDegrees), elevation = glm::radians(viewpoint.elevationDegrees);
    const glm::vec3 back(std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation));
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.0F, 1.0F, 0.0F), back));
    return {right, glm::cross(back, right), back};
}

}  // namespace

Framing frameScene(const Scene& scene, float aspect)
{
    const glm::mat3 toCamera = glm::transpose(axes(Viewpoint{}));

    // The middle is that of the extents along the camera's axes: a box along the world's axes can be
    // much larger than what is in it.
    glm::vec3 least(std::numeric_limits<float>::max()), most = -least;
    forEachPoint(scene, [&](glm::vec3 point) {
        least = glm::min(least, toCamera * point);
        most = glm::max(most, toCamera * point);
    });
    const glm::vec3 middle = 0.5F * least + 0.5F * most;

    // The nearest distance from which no point leaves the field of view.
    Framing framing{};
    const float tanShort = std::tan(0.5F * fieldOfView);
    framing.tangent = {tanShort * std::max(aspect, 1.0F), tanShort * std::max(1.0F / aspect, 1.0F)};
    forEachPoint(scene, [&](glm::vec3 point) {
        const glm::vec3 offset = toCamera * point - middle;
        framing.distance = std::max({framing.distance, offset.z + margin * std::fabs(offset.x) / framing.tangent.x,
                                     offset.z + margin * std::fabs(offset.y) / framing.tangent.y});
    });
    // A single point has no size: any distance frames it.
    if (!(framing.distance > 0.0F)) framing.distance = 1.0F;
    framing.depth = std::max(0.55F * (most.z - least.z), 1e-3F * framing.distance);
    framing.radius = std::max(0.55F * glm::length(most - least), framing.depth);
    framing.centre = glm::transpose(toCamera) * middle;
    return framing;
}

Camera placeCamera(const Framing& framing, const Viewpoint& viewpoint)
{
    Camera camera{};
    const glm::mat3 axis = axes(viewpoint);
    camera.right = axis[0];
    camera.up = axis[1];
    camera.back = axis[2];
    const glm::vec3 centre = framing.centre + framing.radius * viewpoint.target;
    const float distance = framing.distance / viewpoint.zoom;
    camera.eye = centre + camera.back * distance;

    // From the default direction the scene's extent along it is known, from others its radius.
    const Viewpoint usual;
    const bool isUsual = viewpoint.azimuthDegrees == usual.azimuthDegrees && viewpoint.elevationDegrees == usual.elevationDegrees;
    const float depth = (isUsual ? framing.depth : framing.radius) + framing.radius * glm::length(viewpoint.target);
    const float farthest = distance + depth;
    const float nearest = std::max(distance - depth, 1e-3F * distance);
    const glm::vec2 corner = framing.tangent * nearest;
    const glm::mat4 projection = glm::frustum(-corner.x, corner.x, -corner.y, corner.y, nearest, farthest);
    camera.worldToClip = projection * glm::lookAt(camera.eye, centre, glm::vec3(0.0F, 1.0F, 0.0F));
    return camera;
}

}  // namespace nacre::demo
