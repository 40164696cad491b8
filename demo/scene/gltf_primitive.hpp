#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "scene.hpp"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace nacre::demo {

/// What a scene may still take. Primitives can share one accessor a thousandfold, so checking each
/// against the file's size is not enough.
struct Budget {
    std::size_t vertices = std::size_t{1} << 25;  // 1.3 GB of Vertex
    std::size_t indices = std::size_t{1} << 27;   // 0.5 GB
};

/// Takes what the primitive may need at most off the budget, before anything is read. `place`
/// starts the message of a LoadFailure, here and below.
void takeFromBudget(Budget& budget, const tinygltf::Model& model,
                    const tinygltf::Primitive& primitive, const std::string& place);

/// Reads the triangles of a primitive; nothing for points, lines, or triangles without area only.
/// Missing or broken normals and tangents are made up.
std::optional<Mesh> readPrimitive(const tinygltf::Model& model,
                                  const tinygltf::Primitive& primitive, const std::string& place);

}  // namespace nacre::demo
