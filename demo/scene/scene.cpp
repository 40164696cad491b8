#include "scene.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>

#include "gltf_model.hpp"
#include "gltf_nodes.hpp"
#include "gltf_primitive.hpp"
#include "load_failure.hpp"

namespace nacre::demo {

namespace {

// 72 MB of Instance; one node may place a mesh of thousands of primitives.
constexpr std::size_t kMostInstances = std::size_t{1} << 20;

// Squares of distances up to this, and sums of them, stay within single precision (3.4e38).
constexpr double kMostCoordinate = 1e18;
constexpr double kLeastExtent = 1e-15;

/// A glTF mesh in Scene::meshes, where each of its primitives is a mesh of its own.
struct MeshRange {
    std::size_t first;
    std::size_t count;
};

/// Calls `visit(primitive, place)` for each primitive of a glTF mesh.
template <class Visit>
void forEachPrimitive(const tinygltf::Model& model, std::size_t mesh, const Visit& visit) {
    const auto& primitives = model.meshes.at(mesh).primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        visit(primitives[i],
              "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(i) + "]");
    }
}

MeshRange addMesh(Scene& scene, const tinygltf::Model& model, std::size_t index) {
    MeshRange range{scene.meshes.size(), 0};
    forEachPrimitive(model, index, [&](const auto& primitive, const std::string& place) {
        if (auto mesh = readPrimitive(model, primitive, place)) {
            scene.meshes.push_back(std::move(*mesh));
            ++range.count;
        }
    });
    return range;
}

/// Refuses a scene that is small as a file and huge in memory, before any of it is read.
void checkSize(const tinygltf::Model& model, const std::vector<PlacedMesh>& placed) {
    Budget budget;
    std::size_t instances = 0;
    std::vector<bool> counted(model.meshes.size());
    for (const PlacedMesh& place : placed) {
        instances += model.meshes.at(place.mesh).primitives.size();
        if (instances > kMostInstances) {
            throw LoadFailure("scene has too many instances, expected at most " +
                              std::to_string(kMostInstances));
        }
        if (counted[place.mesh]) continue;
        counted[place.mesh] = true;
        forEachPrimitive(model, place.mesh, [&](const auto& primitive, const std::string& name) {
            takeFromBudget(budget, model, primitive, name);
        });
    }
}

/// In single precision, or nothing when the transform or its inverse, which normals need, does not
/// exist there. Section 3.5.3 of glTF 2.0 lets such nodes go: some exporters hide objects so.
std::optional<glm::mat4> invertible(const glm::dmat4& transform) {
    const auto fits = [](const glm::dmat4& matrix) {
        for (int i = 0; i < 16; ++i) {
            if (!(std::abs(matrix[i / 4][i % 4]) <= std::numeric_limits<float>::max()))
                return false;
        }
        return true;
    };
    if (!fits(transform) || glm::determinant(glm::dmat3(transform)) == 0.0) return std::nullopt;
    const glm::mat4 single(transform);
    if (glm::determinant(glm::mat3(single)) == 0.0f || !fits(glm::dmat4(glm::inverse(single)))) {
        return std::nullopt;
    }
    return single;
}

/// Of the vertices in use: primitives may share arrays and draw but a part of them.
Bounds boundsOf(const Mesh& mesh) {
    Bounds bounds{mesh.vertices[mesh.indices[0]].position, mesh.vertices[mesh.indices[0]].position};
    for (const std::uint32_t index : mesh.indices) {
        bounds.least = glm::min(bounds.least, mesh.vertices[index].position);
        bounds.most = glm::max(bounds.most, mesh.vertices[index].position);
    }
    return bounds;
}

/// James Arvo (1990), "Transforming Axis-Aligned Bounding Boxes": encloses the turned box, hence
/// somewhat more than the turned mesh, at a cost that does not depend on the mesh.
void enclose(glm::dvec3& least, glm::dvec3& most, const Bounds& object, const glm::mat4& toWorld) {
    glm::dvec3 low(toWorld[3]), high(toWorld[3]);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 direction(toWorld[axis]);
        const glm::dvec3 a = direction * static_cast<double>(object.least[axis]);
        const glm::dvec3 b = direction * static_cast<double>(object.most[axis]);
        low += glm::min(a, b);
        high += glm::max(a, b);
    }
    least = glm::min(least, low);
    most = glm::max(most, high);
}

Bounds worldBounds(const Scene& scene) {
    std::vector<Bounds> objects;
    objects.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) objects.push_back(boundsOf(mesh));

    glm::dvec3 least(std::numeric_limits<double>::infinity()), most(-least);
    for (const Instance& instance : scene.instances) {
        enclose(least, most, objects[instance.mesh], instance.objectToWorld);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::max(-least[axis], most[axis]) <= kMostCoordinate)) {
            throw LoadFailure("scene reaches too far out, expected coordinates within 1e18");
        }
    }
    // Below, the squares of lengths that framing and noise take would be 0 in float.
    if (!(glm::length(most - least) >= kLeastExtent)) {
        throw LoadFailure("scene is smaller than 1e-15, expected something to see");
    }
    return {glm::vec3(least), glm::vec3(most)};
}

Scene buildScene(const tinygltf::Model& model) {
    const std::vector<PlacedMesh> placed = placedMeshes(model);
    checkSize(model, placed);
    Scene scene;
    std::vector<std::optional<MeshRange>> ranges(model.meshes.size());
    for (const PlacedMesh& place : placed) {
        const auto objectToWorld = invertible(place.objectToWorld);
        if (!objectToWorld) continue;
        auto& range = ranges.at(place.mesh);
        if (!range) range = addMesh(scene, model, place.mesh);
        for (std::size_t i = 0; i < range->count; ++i) {
            scene.instances.push_back({range->first + i, *objectToWorld});
        }
    }
    if (scene.instances.empty()) {
        throw LoadFailure(
            "nothing to draw, expected a scene with a node that has a mesh of triangles");
    }
    scene.bounds = worldBounds(scene);
    return scene;
}

Error failureOf(const std::filesystem::path& file, const std::string& reason) {
    std::string message = "cannot load '" + file.string() + "': " + reason;
    // Names of files and extensions may hold anything.
    for (char& c : message) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = ' ';
    }
    return {std::move(message)};
}

}  // namespace

bool isMirrored(const Instance& instance) {
    return glm::determinant(glm::dmat3(instance.objectToWorld)) < 0.0;
}

Result<Scene> loadScene(const std::filesystem::path& file) {
    try {
        return buildScene(readModel(file));
    } catch (const std::bad_alloc&) {
        return failureOf(file, "not enough memory, expected a smaller file");
    } catch (const std::length_error&) {
        return failureOf(file, "not enough memory, expected a smaller file");
    } catch (const std::exception& failure) {
        return failureOf(file, failure.what());
    }
}

}  // namespace nacre::demo
