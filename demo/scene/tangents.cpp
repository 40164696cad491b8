#include "tangents.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "normals.hpp"

namespace nacre::demo {

namespace {

/// Where the texture's right and up point, summed over the faces around a vertex.
struct TextureFrame {
    glm::dvec3 right{0.0};
    glm::dvec3 up{0.0};
};

/// Eric Lengyel (2001), "Computing Tangent Space Basis Vectors for an Arbitrary Mesh".
/// Differs: a face weighs as much as its area, not as its stretched texture; up is -v, because
/// glTF's v points down the image while its bitangent points up. Unlike MikkTSpace, which glTF
/// suggests for normal maps, no vertex is split: nothing here reads normal maps, and the direction
/// of brushed anisotropy is the same on both sides of a mirrored seam.
std::vector<TextureFrame> textureFrames(const Mesh& mesh, const std::vector<glm::vec2>& texCoords) {
    std::vector<TextureFrame> frames(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto* corner = &mesh.indices[i];
        const auto position = [&](int k) { return mesh.vertices[corner[k]].position; };
        const glm::dvec3 edge1 = glm::dvec3(position(1)) - glm::dvec3(position(0));
        const glm::dvec3 edge2 = glm::dvec3(position(2)) - glm::dvec3(position(0));
        const glm::dvec2 uv0 = texCoords[corner[0]];
        const glm::dvec2 uv1 = glm::dvec2(texCoords[corner[1]]) - uv0;
        const glm::dvec2 uv2 = glm::dvec2(texCoords[corner[2]]) - uv0;
        const double uvArea = uv1.x * uv2.y - uv2.x * uv1.y;
        if (!(std::abs(uvArea) > 0 && std::isfinite(uvArea))) continue;
        const double side = uvArea < 0 ? -1.0 : 1.0;
        const glm::dvec3 right = unitOrZero(side * (edge1 * uv2.y - edge2 * uv1.y));
        const glm::dvec3 up = unitOrZero(side * (edge1 * uv2.x - edge2 * uv1.x));
        const double area = glm::length(doubledArea(position(0), position(1), position(2)));
        for (int k = 0; k < 3; ++k) {
            frames[corner[k]].right += area * right;
            frames[corner[k]].up += area * up;
        }
    }
    return frames;
}

/// The part of a direction perpendicular to the normal, or zero where rounding would decide it:
/// float directions are good to 1e-7, so below 1e-3 of its length less than four digits are left.
glm::vec3 perpendicularTo(const glm::vec3& normal, const glm::dvec3& direction) {
    constexpr double least = 1e-3;
    const glm::dvec3 n(normal);
    const glm::dvec3 unit = unitOrZero(direction);
    const glm::dvec3 perpendicular = unit - n * (glm::dot(n, unit) / glm::dot(n, n));
    if (!(glm::length(perpendicular) > least)) return glm::vec3(0.0f);
    return unitOrZero(perpendicular);
}

/// Jeppe Revall Frisvad (2012), "Building an Orthonormal Basis from a 3D Unit Vector Without
/// Normalization", whose one singular direction is turned down, to -Y: no frame is smooth all over
/// a sphere, and the underside is seen least. Duff et al. (2017) is as short but breaks
/// along a whole circle.
glm::vec3 smoothTangent(const glm::vec3& normal) {
    const glm::dvec3 n(normal);
    const double sinSquared = n.x * n.x + n.z * n.z;
    if (n.y < 0 && sinSquared == 0) return {1.0f, 0.0f, 0.0f};
    // 1 / (1 + y); below, 1 + y = sin² / (1 - y) does not cancel.
    const double a = n.y < 0 ? (1.0 - n.y) / sinSquared : 1.0 / (1.0 + n.y);
    return perpendicularTo(normal, {1.0 - a * n.x * n.x, -n.x, -a * n.x * n.z});
}

/// The vertex's own tangent when it is usable, else a zero vector.
glm::vec4 fileTangent(const Vertex& vertex) {
    const glm::vec4 t = vertex.tangent;
    if (!(std::abs(t.w) > 0.0f)) return glm::vec4(0.0f);
    return {perpendicularTo(vertex.normal, glm::dvec3(t)), t.w < 0.0f ? -1.0f : 1.0f};
}

glm::vec4 frameTangent(const Vertex& vertex, const TextureFrame& frame) {
    const glm::vec3 tangent = perpendicularTo(vertex.normal, frame.right);
    const glm::dvec3 bitangent = glm::cross(glm::dvec3(vertex.normal), glm::dvec3(tangent));
    return {tangent, glm::dot(bitangent, frame.up) < 0.0 ? -1.0f : 1.0f};
}

}  // namespace

void completeTangents(Mesh& mesh, const std::vector<glm::vec2>& texCoords) {
    const auto hasTangent = [](const Vertex& vertex) {
        return glm::vec3(vertex.tangent) != glm::vec3(0.0f);
    };
    for (Vertex& vertex : mesh.vertices) vertex.tangent = fileTangent(vertex);
    if (std::all_of(mesh.vertices.begin(), mesh.vertices.end(), hasTangent)) return;

    const auto frames = texCoords.empty() ? std::vector<TextureFrame>(mesh.vertices.size())
                                          : textureFrames(mesh, texCoords);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        Vertex& vertex = mesh.vertices[i];
        if (!hasTangent(vertex)) vertex.tangent = frameTangent(vertex, frames[i]);
        if (!hasTangent(vertex)) vertex.tangent = {smoothTangent(vertex.normal), 1.0f};
    }
}

}  // namespace nacre::demo
