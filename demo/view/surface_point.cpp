#include "surface_point.hpp"

#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>

#include "render/gpu_scene.hpp"

namespace nacre::demo {
namespace {

struct Hit {
    const Instance* instance = nullptr;
    std::size_t firstIndex = 0;
    double along = std::numeric_limits<double>::infinity();
    double u = 0.0, v = 0.0;  // of the second and the third corner
};

// Möller & Trumbore, "Fast, minimum storage ray/triangle intersection" (1997), from both sides.
void meet(Hit& hit, const Instance& instance, const Mesh& mesh, std::size_t first, glm::dvec3 origin, glm::dvec3 direction)
{
    const auto corner = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[first + i]].position); };
    const glm::dvec3 a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
    const glm::dvec3 p = glm::cross(direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return;
    const glm::dvec3 toOrigin = origin - a;
    const double u = glm::dot(toOrigin, p) / determinant;
    if (!(u >= 0.0 && u <= 1.0)) return;
    const glm::dvec3 q = glm::cross(toOrigin, ab);
    const double v = glm::dot(direction, q) / determinant;
    if (!(v >= 0.0 && u + v <= 1.0)) return;
    const double along = glm::dot(ac, q) / determinant;
    if (along > 0.0 && along < hit.along) hit = {&instance, first, along, u, v};
}

}  // namespace

std::optional<SurfacePoint> pointAt(const Scene& scene, const Camera& camera, glm::dvec2 place)
{
    // From the eye through the far plane; the near plane cuts nothing that the camera is meant to see.
    const glm::dmat4 clipToWorld = glm::inverse(glm::dmat4(camera.worldToClip));
    const glm::dvec4 far = clipToWorld * glm::dvec4(place, 1.0, 1.0);
    const glm::dvec3 eye(camera.eye), direction = glm::dvec3(far) / far.w - eye;

    Hit hit;
    for (const Instance& instance : scene.instances) {
        const glm::dmat4 worldToObject = glm::inverse(glm::dmat4(instance.objectToWorld));
        const glm::dvec3 origin(worldToObject * glm::dvec4(eye, 1.0)), towards(worldToObject * glm::dvec4(direction, 0.0));
        const Mesh& mesh = scene.meshes[instance.mesh];
        for (std::size_t first = 0; first < mesh.indices.size(); first += 3) meet(hit, instance, mesh, first, origin, towards);
    }
    if (!hit.instance) return std::nullopt;

    const Mesh& mesh = scene.meshes[hit.instance->mesh];
    const auto corner = [&](std::size_t i) { return mesh.vertices[mesh.indices[hit.firstIndex + i]]; };
    const auto between = [&](auto member) {
        return (1.0 - hit.u - hit.v) * member(corner(0)) + hit.u * member(corner(1)) + hit.v * member(corner(2));
    };
    // As meshVertexShader carries them to the world.
    const glm::dmat4 objectToWorld(hit.instance->objectToWorld);
    const glm::dmat3 linear(objectToWorld);
    SurfacePoint point;
    point.position = glm::dvec3(objectToWorld * glm::dvec4(between([](const Vertex& v) { return glm::dvec3(v.position); }), 1.0));
    point.normal = glm::inverseTranspose(linear) * between([](const Vertex& v) { return glm::dvec3(v.normal); });
    point.tangent = glm::dvec4(linear * between([](const Vertex& v) { return glm::dvec3(v.tangent); }),
                               static_cast<double>(corner(0).tangent.w) * glm::sign(glm::determinant(linear)));
    // The front of a triangle is where its corners turn counter-clockwise, in its own space.
    const glm::dvec3 a(corner(0).position), b(corner(1).position), c(corner(2).position);
    const glm::dvec3 front = glm::inverseTranspose(linear) * glm::cross(b - a, c - a);
    if (glm::dot(front, direction) > 0.0) point.normal = -point.normal;
    const NoiseSpace noise = noiseSpace(scene);
    point.noisePosition = (point.position - glm::dvec3(noise.centre)) / static_cast<double>(noise.radius);
    return point;
}

}  // namespace nacre::demo
