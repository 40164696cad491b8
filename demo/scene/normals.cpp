#include "normals.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace nacre::demo {

glm::dvec3 doubledArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 origin(a);
    return glm::cross(glm::dvec3(b) - origin, glm::dvec3(c) - origin);
}

glm::vec3 unitOrZero(const glm::dvec3& direction) {
    const double length = glm::length(direction);
    if (!(length > 0 && std::isfinite(length))) return glm::vec3(0.0f);
    return glm::vec3(direction / length);
}

void repairNormals(Mesh& mesh) {
    std::vector<glm::dvec3> faces;  // by vertex; most meshes never need it
    for (Vertex& vertex : mesh.vertices) {
        vertex.normal = unitOrZero(glm::dvec3(vertex.normal));
        if (vertex.normal == glm::vec3(0.0f)) faces.resize(mesh.vertices.size());
    }
    if (faces.empty()) return;

    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto* corner = &mesh.indices[i];
        const glm::dvec3 area =
            doubledArea(mesh.vertices[corner[0]].position, mesh.vertices[corner[1]].position,
                        mesh.vertices[corner[2]].position);
        for (int k = 0; k < 3; ++k) faces[corner[k]] += area;
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        glm::vec3& normal = mesh.vertices[i].normal;
        if (normal == glm::vec3(0.0f)) normal = unitOrZero(faces[i]);
        if (normal == glm::vec3(0.0f)) normal = {0.0f, 1.0f, 0.0f};
    }
}

}  // namespace nacre::demo
