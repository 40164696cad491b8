#pragma once

#include <filesystem>

namespace tinygltf {
class Model;
}

namespace nacre::demo {

/// Reads a .gltf or .glb file with all its buffers. In the model every index is within its array
/// and nothing but buffers, views, accessors, meshes, nodes and scenes is there; the ranges of
/// views and accessors are yet to be checked. Throws LoadFailure and what the containers throw.
tinygltf::Model readModel(const std::filesystem::path& file);

}  // namespace nacre::demo
