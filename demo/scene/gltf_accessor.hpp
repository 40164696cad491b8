#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace tinygltf {
class Model;
}

namespace nacre::demo {

/// The element count an accessor claims; unchecked until it is read.
std::size_t accessorCount(const tinygltf::Model& model, int accessor);

/// Reads an accessor of 2, 3 or 4 float, byte or short components, normalized or not
/// (KHR_mesh_quantization), sparse or not. Floats may be non-finite. Its whole range is checked
/// before anything is allocated. Throws LoadFailure.
template <int components>
std::vector<glm::vec<components, float>> readVectors(const tinygltf::Model& model, int accessor);

/// Reads an accessor of unsigned integers; the values are not compared with anything.
std::vector<std::uint32_t> readIndices(const tinygltf::Model& model, int accessor);

}  // namespace nacre::demo
