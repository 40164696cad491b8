#include "gltf_primitive.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gltf_accessor.hpp"
#include "load_failure.hpp"
#include "normals.hpp"
#include "tangents.hpp"

namespace nacre::demo {

namespace {

/// The arrays of a primitive as in the file; optional ones may be empty.
struct Attributes {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec2> texCoords;
};

void take(std::size_t& budget, std::size_t amount, const std::string& place, const char* what) {
    if (amount > budget) {
        throw LoadFailure(place + " brings " + std::to_string(amount) + " more " + what +
                          ", expected at most " + std::to_string(budget));
    }
    budget -= amount;
}

/// -1 when the primitive has no such attribute.
int accessorOf(const tinygltf::Primitive& primitive, const char* attribute) {
    const auto found = primitive.attributes.find(attribute);
    return found == primitive.attributes.end() ? -1 : found->second;
}

template <int components>
std::vector<glm::vec<components, float>> readAttribute(const tinygltf::Model& model,
                                                       const tinygltf::Primitive& primitive,
                                                       const char* attribute, std::size_t count,
                                                       const std::string& place) {
    const int accessor = accessorOf(primitive, attribute);
    if (accessor < 0) return {};
    if (accessorCount(model, accessor) != count) {
        throw LoadFailure(place + "." + attribute + " has " +
                          std::to_string(accessorCount(model, accessor)) +
                          " elements, expected as many as POSITION, " + std::to_string(count));
    }
    return readVectors<components>(model, accessor);
}

Attributes readAttributes(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                          const std::string& place) {
    const std::size_t count = accessorCount(model, accessorOf(primitive, "POSITION"));
    Attributes attributes;
    attributes.positions = readAttribute<3>(model, primitive, "POSITION", count, place);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 p = attributes.positions[i];
        if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) {
            throw LoadFailure(place + ".POSITION holds a vertex that is not finite, number " +
                              std::to_string(i));
        }
    }
    attributes.normals = readAttribute<3>(model, primitive, "NORMAL", count, place);
    attributes.texCoords = readAttribute<2>(model, primitive, "TEXCOORD_0", count, place);
    // glTF 2.0, section 3.7.2.1: without normals, the file's tangents are to be ignored.
    if (!attributes.normals.empty()) {
        attributes.tangents = readAttribute<4>(model, primitive, "TANGENT", count, place);
    }
    return attributes;
}

/// The vertices in drawing order, each checked against the number of vertices.
std::vector<std::uint32_t> drawingOrder(const tinygltf::Model& model,
                                        const tinygltf::Primitive& primitive,
                                        std::size_t vertexCount, const std::string& place) {
    std::vector<std::uint32_t> order;
    if (primitive.indices < 0) {
        order.resize(vertexCount);
        std::iota(order.begin(), order.end(), 0u);
        return order;
    }
    order = readIndices(model, primitive.indices);
    for (const std::uint32_t index : order) {
        if (index >= vertexCount) {
            throw LoadFailure(place + " has index " + std::to_string(index) +
                              ", expected below the number of vertices, " +
                              std::to_string(vertexCount));
        }
    }
    return order;
}

/// Lists, strips and fans as lists (glTF 2.0, section 3.7.2.1), without the triangles that name a
/// vertex twice: strips are stitched with them.
std::vector<std::uint32_t> triangleList(const std::vector<std::uint32_t>& order, int mode,
                                        const std::string& place) {
    const std::size_t count = order.size();
    const bool isList = mode == TINYGLTF_MODE_TRIANGLES;
    if (count < 3 || (isList && count % 3 != 0)) {
        throw LoadFailure(place + " draws " + std::to_string(count) + " vertices, expected " +
                          (isList ? "a multiple of 3" : "at least 3"));
    }
    std::vector<std::uint32_t> triangles;
    triangles.reserve(isList ? count : (count - 2) * 3);
    const auto add = [&](std::size_t i, std::size_t j, std::size_t k) {
        const std::uint32_t a = order[i], b = order[j], c = order[k];
        if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
    };
    if (isList) {
        for (std::size_t i = 0; i + 2 < count; i += 3) add(i, i + 1, i + 2);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
        for (std::size_t i = 0; i + 2 < count; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
    } else {
        for (std::size_t i = 0; i + 2 < count; ++i) add(i + 1, i + 2, 0);
    }
    return triangles;
}

/// Gives each triangle vertices of its own, with the normal of its face: what the specification
/// asks for where normals are missing. Triangles without area have no normal and show nothing.
void shadeFlat(Attributes& attributes, std::vector<std::uint32_t>& triangles) {
    Attributes flat;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return attributes.positions[triangles[i + k]]; };
        const glm::vec3 normal = unitOrZero(doubledArea(corner(0), corner(1), corner(2)));
        if (normal == glm::vec3(0.0f)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            flat.positions.push_back(corner(k));
            flat.normals.push_back(normal);
            if (!attributes.texCoords.empty()) {
                flat.texCoords.push_back(attributes.texCoords[triangles[i + k]]);
            }
        }
    }
    attributes = std::move(flat);
    triangles.resize(attributes.positions.size());
    std::iota(triangles.begin(), triangles.end(), 0u);
}

/// glTF 2.0, section 3.7.2.1, again: without positions, a primitive is for extensions to draw.
bool hasTriangles(const tinygltf::Primitive& primitive) {
    return primitive.mode >= TINYGLTF_MODE_TRIANGLES && accessorOf(primitive, "POSITION") >= 0;
}

}  // namespace

void takeFromBudget(Budget& budget, const tinygltf::Model& model,
                    const tinygltf::Primitive& primitive, const std::string& place) {
    if (!hasTriangles(primitive)) return;
    const std::size_t vertices = accessorCount(model, accessorOf(primitive, "POSITION"));
    const std::size_t drawn =
        primitive.indices < 0 ? vertices : accessorCount(model, primitive.indices);
    take(budget.vertices, vertices, place, "vertices");
    take(budget.indices, drawn, place, "indices");
    // A strip of n vertices becomes a list of less than 3n; each is a vertex when shaded flat.
    const std::size_t listed = primitive.mode == TINYGLTF_MODE_TRIANGLES ? drawn : 3 * drawn;
    take(budget.indices, listed - drawn, place, "indices");
    if (accessorOf(primitive, "NORMAL") < 0) take(budget.vertices, listed, place, "vertices");
}

std::optional<Mesh> readPrimitive(const tinygltf::Model& model,
                                  const tinygltf::Primitive& primitive, const std::string& place) {
    if (!hasTriangles(primitive)) return std::nullopt;
    Attributes attributes = readAttributes(model, primitive, place);
    auto triangles = triangleList(
        drawingOrder(model, primitive, attributes.positions.size(), place), primitive.mode, place);
    if (attributes.normals.empty()) shadeFlat(attributes, triangles);
    if (triangles.empty()) return std::nullopt;

    Mesh mesh;
    mesh.indices = std::move(triangles);
    mesh.vertices.resize(attributes.positions.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.vertices[i] = {attributes.positions[i], attributes.normals[i],
                            attributes.tangents.empty() ? glm::vec4(0.0f) : attributes.tangents[i]};
    }
    repairNormals(mesh);
    completeTangents(mesh, attributes.texCoords);
    return mesh;
}

}  // namespace nacre::demo
