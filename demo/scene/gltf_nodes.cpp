#include "gltf_nodes.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <string>

#include "load_failure.hpp"

namespace nacre::demo {

namespace {

// Assemblies nest tens of levels; exporters that nest hundreds are in a loop.
constexpr std::size_t kMostDepth = 256;

std::string named(std::size_t node) { return "nodes[" + std::to_string(node) + "]"; }

bool isFinite(const glm::dmat4& matrix) {
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(matrix[i / 4][i % 4])) return false;
    }
    return true;
}

glm::dmat4 localTransform(const tinygltf::Node& node, const std::string& name) {
    if (!node.matrix.empty()) return glm::make_mat4(node.matrix.data());
    glm::dmat4 transform(1.0);
    if (!node.translation.empty()) {
        transform = glm::translate(transform, glm::make_vec3(node.translation.data()));
    }
    if (!node.rotation.empty()) {
        const auto& r = node.rotation;  // x, y, z, w
        const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
        if (!(length > 0 && std::isfinite(length))) {
            throw LoadFailure(name + ".rotation has length " + std::to_string(length) +
                              ", expected a unit quaternion");
        }
        transform *=
            glm::mat4_cast(glm::dquat(r[3] / length, r[0] / length, r[1] / length, r[2] / length));
    }
    if (!node.scale.empty()) {
        transform = glm::scale(transform, glm::make_vec3(node.scale.data()));
    }
    return transform;
}

std::vector<int> rootNodes(const tinygltf::Model& model) {
    if (!model.scenes.empty()) {
        return model.scenes.at(static_cast<std::size_t>(std::max(model.defaultScene, 0))).nodes;
    }
    std::vector<bool> isChild(model.nodes.size());
    for (const auto& node : model.nodes) {
        for (const int child : node.children) isChild.at(static_cast<std::size_t>(child)) = true;
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        if (!isChild[i]) roots.push_back(static_cast<int>(i));
    }
    if (roots.empty() && !model.nodes.empty()) {
        throw LoadFailure("nodes form a cycle, expected a tree");
    }
    return roots;
}

}  // namespace

std::vector<PlacedMesh> placedMeshes(const tinygltf::Model& model) {
    struct Pending {
        int node;
        std::size_t depth;
        glm::dmat4 parentToWorld;
    };
    std::vector<Pending> pending;
    const auto push = [&](const std::vector<int>& nodes, std::size_t depth,
                          const glm::dmat4& parentToWorld) {
        // In reverse, so that they are taken in the order of the file.
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            pending.push_back({*node, depth, parentToWorld});
        }
    };
    push(rootNodes(model), 1, glm::dmat4(1.0));

    std::vector<PlacedMesh> placed;
    std::vector<bool> reached(model.nodes.size());
    while (!pending.empty()) {
        const Pending next = pending.back();
        pending.pop_back();
        const auto index = static_cast<std::size_t>(next.node);
        const tinygltf::Node& node = model.nodes.at(index);
        if (reached[index]) {
            throw LoadFailure(named(index) +
                              " is reached twice, expected a tree without cycles or shared nodes");
        }
        reached[index] = true;
        if (next.depth > kMostDepth) {
            throw LoadFailure(named(index) + " is nested deeper than " +
                              std::to_string(kMostDepth) + " levels, expected fewer");
        }
        const glm::dmat4 toWorld = next.parentToWorld * localTransform(node, named(index));
        if (!isFinite(toWorld)) {
            throw LoadFailure(named(index) + " has a transform to the world that is not finite");
        }
        if (node.mesh >= 0) placed.push_back({static_cast<std::size_t>(node.mesh), toWorld});
        push(node.children, next.depth + 1, toWorld);
    }
    return placed;
}

}  // namespace nacre::demo
