#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nacre/result.hpp>
#include <vector>

namespace nacre::demo {

/// All in object space. Normal and tangent have unit length and are perpendicular; the bitangent is
/// `cross(normal, tangent.xyz) * tangent.w` with w = 1 or -1, as in glTF.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec4 tangent;
};

/// Triangles, three indices each, counter-clockwise as seen from the front.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// One mesh placed in the world. The transform is finite and invertible, but it may mirror.
struct Instance {
    std::size_t mesh;
    glm::mat4 objectToWorld;
};

/// True when the instance turns left hands into right ones. Mirrored and unmirrored instances share
/// a mesh, so the loader leaves the vertices alone and whoever draws the instance accounts for it:
/// there the front of a triangle is clockwise (glFrontFace), and a bitangent built from the
/// transformed normal and tangent needs -tangent.w.
bool isMirrored(const Instance& instance);

struct Bounds {
    glm::vec3 least;
    glm::vec3 most;
};

struct Scene {
    std::vector<Mesh> meshes;         ///< one for each glTF primitive of triangles in use
    std::vector<Instance> instances;  ///< never empty
    Bounds bounds;                    ///< encloses every instance, in the world
};

/// Reads the triangles of a glTF 2.0 file, .gltf or .glb, each mesh where its node places it: its default scene, else its
/// first, else all its root nodes. Left out: points, lines, materials
/// (all faces are drawn from both sides), textures, skins (a skinned mesh stands where its node does), morph
/// targets, animations, cameras, and meshes flattened by a transform that cannot be inverted.
/// Nothing is thrown or printed; the error is one line: file, reason, what would be right.
Result<Scene> loadScene(const std::filesystem::path& file);

}  // namespace nacre::demo
