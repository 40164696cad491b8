#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gltf_builder.hpp"
#include "scene/scene.hpp"

namespace nacre::test {

using demo::loadScene;
using demo::Mesh;
using demo::Scene;
using demo::Vertex;

/// Every load writes one file of its own directory.
inline Result<Scene> load(const std::string& bytes) {
    const TemporaryDirectory directory;
    return loadScene(directory.write("scene", bytes));
}

/// The scene, or a failed test and an empty one.
inline Scene loaded(const std::string& bytes) {
    auto scene = load(bytes);
    if (scene) return *std::move(scene);
    ADD_FAILURE() << scene.error().message;
    return {};
}

/// The reason of a failure, without the file that it has to start with.
inline std::string reasonOf(const std::string& bytes) {
    const TemporaryDirectory directory;
    const auto file = directory.write("scene", bytes);
    const auto scene = loadScene(file);
    if (scene) return "no failure";
    const std::string start = "cannot load '" + file.string() + "': ";
    EXPECT_EQ(scene.error().message.substr(0, start.size()), start);
    return scene.error().message.substr(start.size());
}

/// Why the square fails after its document has been spoiled; as .glb and .gltf alike.
inline std::string spoiled(const std::function<void(Json&)>& spoil) {
    GltfBuilder builder = square();
    spoil(builder.json);
    const std::string reason = reasonOf(builder.glb());
    EXPECT_EQ(reasonOf(builder.gltf()), reason);
    return reason;
}

/// What Vertex and Mesh promise. Unit vectors rounded to float are good to 1e-6; so are their
/// products.
inline ::testing::AssertionResult isSound(const Scene& scene) {
    constexpr float tolerance = 1e-6f;
    const auto fails = [](const char* what) { return ::testing::AssertionFailure() << what; };
    const auto unit = [&](const glm::vec3& v) {
        return std::abs(glm::length(v) - 1.0f) < tolerance;
    };
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.indices.empty() || mesh.indices.size() % 3 != 0) return fails("index count");
        for (const auto index : mesh.indices) {
            if (index >= mesh.vertices.size()) return fails("index out of range");
        }
        for (const Vertex& vertex : mesh.vertices) {
            const glm::vec3 tangent(vertex.tangent);
            if (!std::isfinite(glm::dot(glm::dvec3(vertex.position), glm::dvec3(1))))
                return fails("position");
            if (!unit(vertex.normal) || !unit(tangent)) return fails("length");
            if (!(std::abs(glm::dot(vertex.normal, tangent)) < tolerance))
                return fails("tangent is skew");
            if (std::abs(vertex.tangent.w) != 1.0f) return fails("handedness");
        }
    }
    for (const auto& instance : scene.instances) {
        if (instance.mesh >= scene.meshes.size()) return fails("mesh out of range");
        const glm::mat4 inverse = glm::inverse(instance.objectToWorld);
        for (int i = 0; i < 16; ++i) {
            if (!std::isfinite(instance.objectToWorld[i / 4][i % 4])) return fails("transform");
            if (!std::isfinite(inverse[i / 4][i % 4])) return fails("inverse");
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!(scene.bounds.least[axis] <= scene.bounds.most[axis])) return fails("bounds");
    }
    return scene.instances.empty() ? fails("no instance") : ::testing::AssertionSuccess();
}

/// The square with two corners moved by sparse values.
inline GltfBuilder sparseSquare() {
    GltfBuilder builder = square();
    const auto places = builder.view(bytesOf<std::uint16_t>({1, 2}));
    const auto values = builder.view(bytesOf<float>({5, 0, 0, 5, 5, 0}));
    builder.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", places}, {"componentType", kUnsignedShort}}},
        {"values", {{"bufferView", values}}}};
    return builder;
}

}  // namespace nacre::test
