#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <vector>

namespace tinygltf {
class Model;
}

namespace nacre::demo {

/// A glTF mesh where a node puts it.
struct PlacedMesh {
    std::size_t mesh;
    glm::dmat4 objectToWorld;
};

/// Walks the default scene, else the first, else all root nodes. Throws LoadFailure for nodes that
/// form no tree or nest too deep, and for transforms that are not finite.
std::vector<PlacedMesh> placedMeshes(const tinygltf::Model& model);

}  // namespace nacre::demo
