#include "scene/scene.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <random>

#include "gltf_builder.hpp"

// Two seconds with sanitizers; a longer search defines more.
#ifndef NACRE_FUZZ_ROUNDS
#define NACRE_FUZZ_ROUNDS 2000
#endif

namespace {

using namespace nacre::test;
using nacre::demo::loadScene;
using nacre::demo::Mesh;
using nacre::demo::Scene;
using nacre::demo::Vertex;

// Every load in this file writes one file of its own directory.
nacre::Result<Scene> load(const std::string& bytes) {
    const TemporaryDirectory directory;
    return loadScene(directory.write("scene", bytes));
}

/// The scene, or a failed test and an empty one.
Scene loaded(const std::string& bytes) {
    auto scene = load(bytes);
    if (scene) return *std::move(scene);
    ADD_FAILURE() << scene.error().message;
    return {};
}

/// The reason of a failure, without the file that it has to start with.
std::string reasonOf(const std::string& bytes) {
    const TemporaryDirectory directory;
    const auto file = directory.write("scene", bytes);
    const auto scene = loadScene(file);
    if (scene) return "no failure";
    const std::string start = "cannot load '" + file.string() + "': ";
    EXPECT_EQ(scene.error().message.substr(0, start.size()), start);
    return scene.error().message.substr(start.size());
}

/// Why the square fails after its document has been spoiled; as .glb and .gltf alike.
std::string spoiled(const std::function<void(Json&)>& spoil) {
    GltfBuilder builder = square();
    spoil(builder.json);
    const std::string reason = reasonOf(builder.glb());
    EXPECT_EQ(reasonOf(builder.gltf()), reason);
    return reason;
}

/// What Vertex and Mesh promise. Unit vectors rounded to float are good to 1e-6; so are their
/// products.
::testing::AssertionResult isSound(const Scene& scene) {
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

using Indices = std::vector<std::uint32_t>;

TEST(Scene, loadsGlbAndGltfAlike) {
    for (const std::string& bytes :
         {square().glb(), square().gltf(), "\xEF\xBB\xBF\n" + square().gltf()}) {
        const Scene scene = loaded(bytes);
        ASSERT_TRUE(isSound(scene));
        ASSERT_EQ(scene.meshes.size(), 1u);
        ASSERT_EQ(scene.meshes[0].vertices.size(), 4u);
        EXPECT_EQ(scene.meshes[0].indices, (Indices{0, 1, 2, 0, 2, 3}));
        EXPECT_EQ(scene.meshes[0].vertices[2].position, glm::vec3(1, 1, 0));
        EXPECT_EQ(scene.meshes[0].vertices[2].normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(scene.instances[0].objectToWorld, glm::mat4(1.0f));
        EXPECT_EQ(scene.bounds.least, glm::vec3(0, 0, 0));
        EXPECT_EQ(scene.bounds.most, glm::vec3(1, 1, 0));
    }
}

TEST(Scene, readsBufferFiles) {
    GltfBuilder builder = square();
    const TemporaryDirectory directory;
    builder.json["buffers"] = {{{"byteLength", builder.bin.size()}, {"uri", "a%20b+c.bin"}}};
    const auto file = directory.write("scene.gltf", builder.gltf());
    const std::string start = "cannot load '" + file.string() + "': buffer file 'a b+c.bin': ";
    EXPECT_EQ(loadScene(file).error().message,
              start + "no such file, expected the bytes of a buffer");
    directory.write("a b+c.bin", builder.bin.substr(0, 100));
    EXPECT_EQ(loadScene(file).error().message,
              start + "file has 100 bytes, expected at least the buffer's byteLength " +
                  std::to_string(builder.bin.size()));
    directory.write("a b+c.bin", builder.bin + "surplus");
    EXPECT_TRUE(loadScene(file));
}

TEST(Scene, readsEachIndexType) {
    const auto check = [](const std::function<std::size_t(GltfBuilder&)>& add) {
        GltfBuilder builder = square();
        builder.json["meshes"][0]["primitives"][0]["indices"] = add(builder);
        EXPECT_EQ(loaded(builder.glb()).meshes.at(0).indices, (Indices{2, 3, 0}));
    };
    check([](GltfBuilder& b) { return b.indices<std::uint8_t>({2, 3, 0}, kUnsignedByte); });
    check([](GltfBuilder& b) { return b.indices<std::uint16_t>({2, 3, 0}, kUnsignedShort); });
    check([](GltfBuilder& b) { return b.indices<std::uint32_t>({2, 3, 0}, kUnsignedInt); });
}

TEST(Scene, drawsVerticesInOrderWithoutIndices) {
    GltfBuilder builder;
    builder.floats({0, 0, 0, 1, 0, 0, 1, 1, 0}, "VEC3");
    builder.mesh({{"attributes", {{"POSITION", 0}}}});
    builder.rootNode({{"mesh", 0}});
    EXPECT_EQ(loaded(builder.glb()).meshes.at(0).indices, (Indices{0, 1, 2}));
}

TEST(Scene, turnsStripsAndFansIntoLists) {
    const auto indices = [](int mode, const std::vector<std::uint8_t>& order) {
        GltfBuilder builder = square();
        Json& primitive = builder.json["meshes"][0]["primitives"][0];
        primitive["indices"] = builder.indices(order, kUnsignedByte);
        primitive["mode"] = mode;
        return loaded(builder.glb()).meshes.at(0).indices;
    };
    EXPECT_EQ(indices(5, {0, 1, 3, 2}), (Indices{0, 1, 3, 1, 2, 3}));
    EXPECT_EQ(indices(6, {0, 1, 2, 3}), (Indices{1, 2, 0, 2, 3, 0}));
    // A repeated vertex stitches strips; its triangles have no area.
    EXPECT_EQ(indices(5, {0, 1, 1, 3, 2}), (Indices{1, 3, 2}));
}

TEST(Scene, leavesOutPointsAndLines) {
    GltfBuilder builder = square();
    Json points = builder.json["meshes"][0]["primitives"][0];
    points["mode"] = 0;
    builder.json["meshes"][0]["primitives"].push_back(points);
    EXPECT_EQ(loaded(builder.glb()).meshes.size(), 1u);
}

TEST(Scene, placesNodes) {
    GltfBuilder builder = square();
    // A quarter turn about Z takes +X to +Y; scale comes first, translation last.
    builder.json["nodes"][0] = {{"mesh", 0},
                                {"scale", {2, 3, 1}},
                                {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}},
                                {"translation", {10, 0, 0}},
                                {"children", {1}}};
    builder.json["nodes"].push_back(
        {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}});
    const Scene scene = loaded(builder.glb());
    ASSERT_TRUE(isSound(scene));
    EXPECT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 2u);
    const auto corner = [&](std::size_t i) {
        return scene.instances[i].objectToWorld * glm::vec4(1, 1, 0, 1);
    };
    // sqrt(0.5) squares to 0.5 within 1e-16; 1e-5 is float rounding at 10.
    EXPECT_LT(glm::distance(corner(0), glm::vec4(7, 2, 0, 1)), 1e-5f);
    EXPECT_LT(glm::distance(corner(1), glm::vec4(7, 2, 5, 1)), 1e-5f);
    EXPECT_LT(glm::distance(scene.bounds.least, glm::vec3(7, 0, 0)), 1e-5f);
    EXPECT_LT(glm::distance(scene.bounds.most, glm::vec3(10, 2, 5)), 1e-5f);
}

TEST(Scene, tellsMirroredInstances) {
    GltfBuilder builder = square();
    builder.rootNode({{"mesh", 0}, {"scale", {-1, 1, 1}}});
    const Scene scene = loaded(builder.glb());
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_FALSE(isMirrored(scene.instances[0]));
    EXPECT_TRUE(isMirrored(scene.instances[1]));
}

TEST(Scene, leavesOutFlattenedInstances) {
    GltfBuilder builder = square();
    builder.rootNode({{"mesh", 0}, {"scale", {1, 0, 1}}});
    EXPECT_EQ(loaded(builder.glb()).instances.size(), 1u);
}

TEST(Scene, choosesTheScene) {
    GltfBuilder builder = square();
    builder.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 7}}});
    builder.json["scenes"].push_back({{"nodes", {1}}});
    EXPECT_EQ(loaded(builder.glb()).bounds.least.z, 0.0f);  // the first
    builder.json["scene"] = 1;
    EXPECT_EQ(loaded(builder.glb()).bounds.least.z, 7.0f);
    builder.json.erase("scene");
    builder.json.erase("scenes");
    EXPECT_EQ(loaded(builder.glb()).instances.size(), 2u);  // all roots
}

TEST(Scene, unweldsFacesWhereNormalsAreMissing) {
    GltfBuilder builder;
    builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
    // The third triangle has no area.
    builder.indices<std::uint8_t>({0, 1, 2, 0, 2, 3, 1, 1, 2}, kUnsignedByte);
    builder.mesh({{"attributes", {{"POSITION", 0}}}, {"indices", 1}});
    builder.rootNode({{"mesh", 0}});
    const Scene scene = loaded(builder.glb());
    ASSERT_TRUE(isSound(scene));
    ASSERT_EQ(scene.meshes[0].vertices.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(scene.meshes[0].vertices[i].normal,
                  i < 3 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0));
    }
}

TEST(Scene, repairsNormals) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    GltfBuilder builder = square();
    builder.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
        builder.floats({0, 0, 0, nan, 0, 0, 0, 0, 1e30f, 3, 0, 4}, "VEC3");
    const Scene scene = loaded(builder.glb());
    ASSERT_TRUE(isSound(scene));
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(scene.meshes[0].vertices[i].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.meshes[0].vertices[3].normal, glm::vec3(0.6f, 0, 0.8f));
}

TEST(Scene, derivesTangentsFromTextureCoordinates) {
    const Scene upright = loaded(square().glb());
    for (const Vertex& vertex : upright.meshes.at(0).vertices) {
        EXPECT_EQ(vertex.tangent, glm::vec4(1, 0, 0, 1));
    }
    GltfBuilder mirrored = square();
    mirrored.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
        mirrored.floats({1, 1, 0, 1, 0, 0, 1, 0}, "VEC2");
    const Scene turned = loaded(mirrored.glb());
    for (const Vertex& vertex : turned.meshes.at(0).vertices) {
        EXPECT_EQ(vertex.tangent, glm::vec4(-1, 0, 0, -1));
    }
}

TEST(Scene, keepsUsableTangents) {
    GltfBuilder builder = square();
    // The second is parallel to the normal, the third not finite, the fourth without handedness.
    builder.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] =
        builder.floats({0, -1, 0, -1, 0, 0, 1, 1, INFINITY, 0, 0, 1, 0, 1, 0, 0}, "VEC4");
    const Scene scene = loaded(builder.glb());
    ASSERT_TRUE(isSound(scene));
    EXPECT_EQ(scene.meshes[0].vertices[0].tangent, glm::vec4(0, -1, 0, -1));
    for (std::size_t i = 1; i < 4; ++i)
        EXPECT_EQ(scene.meshes[0].vertices[i].tangent, glm::vec4(1, 0, 0, 1));
}

TEST(Scene, framesNormalsWithoutTextureCoordinatesSmoothly) {
    // Normals along a meridian through both poles, in steps of one degree: neighbouring frames
    // may turn as far as the normals do and, close to the singular -Y, not be compared.
    GltfBuilder builder;
    std::vector<float> normals;
    for (int degree = 0; degree < 360; ++degree) {
        const float angle = glm::radians(static_cast<float>(degree));
        normals.insert(normals.end(),
                       {0.6f * std::sin(angle), std::cos(angle), 0.8f * std::sin(angle)});
    }
    builder.floats(normals, "VEC3");
    builder.mesh({{"attributes", {{"POSITION", 0}, {"NORMAL", 0}}}});
    builder.rootNode({{"mesh", 0}});
    const Scene scene = loaded(builder.glb());
    ASSERT_TRUE(isSound(scene));
    const auto& vertices = scene.meshes[0].vertices;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        if (i == 180 || i == 181) continue;
        EXPECT_LT(glm::distance(vertices[i - 1].tangent, vertices[i].tangent), 0.02f) << i;
    }
}

TEST(Scene, readsStridesAndOffsets) {
    GltfBuilder builder;
    // Interleaved, behind four stray bytes: position, normal.
    const auto view =
        builder.view(bytesOf<float>({9, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1}), 24);
    builder.json["accessors"][builder.accessor(view, kFloat, 3, "VEC3")]["byteOffset"] = 4;
    builder.json["accessors"][builder.accessor(view, kFloat, 3, "VEC3")]["byteOffset"] = 16.0;
    builder.mesh({{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}});
    builder.rootNode({{"mesh", 0}});
    const Scene scene = loaded(builder.glb());
    ASSERT_TRUE(isSound(scene));
    EXPECT_EQ(scene.meshes[0].vertices[2].position, glm::vec3(1, 1, 0));
    EXPECT_EQ(scene.meshes[0].vertices[2].normal, glm::vec3(0, 0, 1));
}

TEST(Scene, readsQuantizedAttributes) {
    GltfBuilder builder;
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    builder.accessor(
        builder.view(bytesOf<std::int16_t>({0, 0, 0, 0, -300, 0, 0, 0, 300, 7, 0, 0}), 8), kShort,
        3, "VEC3");
    builder.accessor(
        builder.view(bytesOf<std::int8_t>({0, 0, -128, 0, 0, 0, -127, 0, 0, 0, -127, 0}), 4), kByte,
        3, "VEC3");
    builder.json["accessors"][1]["normalized"] = true;
    builder.mesh({{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}});
    builder.rootNode({{"mesh", 0}});
    const Scene scene = loaded(builder.glb());
    ASSERT_TRUE(isSound(scene));
    EXPECT_EQ(scene.meshes[0].vertices[2].position, glm::vec3(300, 7, 0));
    EXPECT_EQ(scene.meshes[0].vertices[0].normal, glm::vec3(0, 0, -1));
}

/// The square with two corners moved by sparse values.
GltfBuilder sparseSquare() {
    GltfBuilder builder = square();
    const auto places = builder.view(bytesOf<std::uint16_t>({1, 2}));
    const auto values = builder.view(bytesOf<float>({5, 0, 0, 5, 5, 0}));
    builder.json["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", places}, {"componentType", kUnsignedShort}}},
        {"values", {{"bufferView", values}}}};
    return builder;
}

TEST(Scene, readsSparseAccessors) {
    EXPECT_EQ(loaded(sparseSquare().glb()).bounds.most, glm::vec3(5, 5, 0));
    GltfBuilder zeros = sparseSquare();
    zeros.json["accessors"][0].erase("bufferView");
    const Scene scene = loaded(zeros.glb());
    EXPECT_EQ(scene.meshes.at(0).vertices[2].position, glm::vec3(5, 5, 0));
    EXPECT_EQ(scene.meshes.at(0).vertices[3].position, glm::vec3(0, 0, 0));
}

TEST(Scene, ignoresWhatItDoesNotRead) {
    GltfBuilder builder = square();
    builder.json["images"] = {{{"uri", "missing.png"}}, {{"bufferView", 99}}};
    builder.json["textures"] = "nonsense";
    builder.json["skins"] = {{{"joints", {1e300}}}};
    builder.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    builder.json["extensionsRequired"] = {"KHR_materials_iridescence", "KHR_texture_basisu"};
    EXPECT_TRUE(isSound(loaded(builder.glb())));
}

TEST(SceneFailure, files) {
    const TemporaryDirectory directory;
    const auto message = [&](const std::filesystem::path& name) {
        const auto scene = loadScene(directory.path() / name);
        return scene ? "no failure" : scene.error().message;
    };
    const auto expected = [&](const std::string& name, const std::string& reason) {
        return "cannot load '" + (directory.path() / name).string() + "': " + reason +
               ", expected a .gltf or .glb file";
    };
    EXPECT_EQ(message("none.glb"), expected("none.glb", "no such file"));
    EXPECT_EQ(message("two\nlines"), expected("two lines", "no such file"));
    std::filesystem::create_directory(directory.path() / "folder");
    EXPECT_EQ(message("folder"), expected("folder", "is a directory"));
    ASSERT_EQ(mkfifo((directory.path() / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(message("pipe"), expected("pipe", "is not a regular file"));
    std::filesystem::create_symlink("loop", directory.path() / "loop");
    EXPECT_EQ(message("loop"),
              expected("loop", "cannot be read: Too many levels of symbolic links"));
    directory.write("empty", "");
    EXPECT_EQ(message("empty"), expected("empty", "file is empty"));
    if (geteuid() == 0) return;  // who may read everything
    std::filesystem::permissions(directory.write("secret", "{}"), std::filesystem::perms::none);
    EXPECT_EQ(message("secret"), expected("secret", "cannot be read: Permission denied"));
}

TEST(SceneFailure, containers) {
    const std::string glb = square().glb();
    const auto patched = [&](std::size_t at, const std::string& bytes) {
        return reasonOf(std::string(glb).replace(at, bytes.size(), bytes));
    };
    EXPECT_EQ(reasonOf("glTF\2"), "file is truncated: a GLB header has 12 bytes, file has 5");
    EXPECT_EQ(
        reasonOf(glb.substr(0, 100)),
        "file is truncated: header says " + std::to_string(glb.size()) + " bytes, file has 100");
    EXPECT_EQ(patched(4, "\1"), "GLB version is 1, expected 2");
    EXPECT_EQ(patched(8, std::string("\4\0\0\0", 4)),
              "GLB header says 4 bytes, expected at least 12");
    EXPECT_EQ(patched(12, "\xFF\xFF\xFF\xFF"),
              "chunk is truncated: needs 4294967295 bytes, the file's header leaves " +
                  std::to_string(glb.size() - 20));
    EXPECT_EQ(patched(16, "NOPE"),
              "first GLB chunk has type 1162891086, expected 1313821514 (JSON)");
    EXPECT_EQ(reasonOf("solid cube"), "is not glTF: expected it to start with 'glTF' or '{'");
    EXPECT_EQ(reasonOf("{\"asset\": \n\xFF}"),
              "not valid JSON: parse error at line 2, column 1: syntax error while parsing value - "
              "invalid literal; last read: '\"asset\": <U+000A>?'");
    EXPECT_EQ(reasonOf("{\"asset\": 1e999}"), "not valid JSON: number overflow parsing '1e999'");
    EXPECT_EQ(reasonOf("{\"a\":" + std::string(100000, '[')),
              "JSON nests deeper than 64 levels, expected a glTF document");
}

TEST(SceneFailure, documents) {
    EXPECT_EQ(reasonOf("{}"), "asset is missing, expected a glTF 2.0 document");
    EXPECT_EQ(reasonOf(R"({"asset":{"version":"2.0"}})"),
              "nothing to draw, expected a scene with a node that has a mesh of triangles");
    EXPECT_EQ(spoiled([](Json& j) { j["asset"]["version"] = "1.0"; }),
              "asset is of glTF version '1.0', expected '2.0'");
    EXPECT_EQ(spoiled([](Json& j) { j["asset"].erase("version"); }),
              "asset.version is missing, glTF 2.0 requires it");
    EXPECT_EQ(spoiled([](Json& j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
              "extension 'KHR_draco_mesh_compression' is required but not supported, expected a "
              "file exported without it");
    EXPECT_EQ(spoiled([](Json& j) { j["extensionsRequired"] = {"EXT_meshopt_compression"}; }),
              "extension 'EXT_meshopt_compression' is required but not supported, expected a file "
              "exported without it");
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"] = 3; }), "nodes is 3, expected an array");
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"][0] = "x"; }),
              "nodes[0] is of type string, expected an object");
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"][0]["mesh"] = 1; }),
              "nodes[0].mesh is 1, expected an index below 1, the number of meshes");
    EXPECT_EQ(spoiled([](Json& j) { j["scene"] = -1; }),
              "scene is -1, expected an index below 1, the number of scenes");
    EXPECT_EQ(spoiled([](Json& j) {
                  j["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 4294967296;
              }),
              "meshes[0].primitives[0].attributes.NORMAL is 4294967296, expected an index below 4, "
              "the number of accessors");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][0]["count"] = 1e300; }),
              "accessors[0].count is 1e+300, expected an integer from 1 to 9007199254740991");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][0]["type"] = "VEC5"; }),
              "accessors[0].type is unknown, expected SCALAR, VEC2 to VEC4 or MAT2 to MAT4");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][0]["normalized"] = 1; }),
              "accessors[0].normalized is 1, expected true or false");
    EXPECT_EQ(spoiled([](Json& j) { j["bufferViews"][0]["byteStride"] = 14; }),
              "bufferViews[0].byteStride is 14, expected a multiple of 4");
    EXPECT_EQ(spoiled([](Json& j) { j["meshes"][0].erase("primitives"); }),
              "meshes[0].primitives is missing or empty, expected an array");
}

TEST(SceneFailure, buffers) {
    const auto withBuffer = [](const Json& buffer) {
        GltfBuilder builder = square();
        builder.json["buffers"] = {buffer};
        return reasonOf(builder.gltf());
    };
    EXPECT_EQ(
        withBuffer({{"byteLength", 4}}),
        "buffers[0].uri is missing, only the first buffer of a GLB with a BIN chunk needs none");
    EXPECT_EQ(withBuffer({{"byteLength", 4}, {"uri", "data:,abcd"}}),
              "buffers[0].uri is a data URI of unknown encoding, expected base64");
    EXPECT_EQ(withBuffer({{"byteLength", 4}, {"uri", "data:;base64,AA!A"}}),
              "buffers[0].uri has a character at 2 of its data that is none of base64");
    EXPECT_EQ(withBuffer({{"byteLength", 1e15}, {"uri", "data:;base64,AAAA"}}),
              "buffers[0].byteLength is 1000000000000000, but its data URI holds 3 bytes");
    GltfBuilder builder = square();
    builder.json["buffers"] = {{{"byteLength", 1000000}}};
    EXPECT_EQ(reasonOf(builder.glb()),
              "buffers[0].byteLength is 1000000, but its BIN chunk holds " +
                  std::to_string(builder.bin.size()) + " bytes");
}

TEST(SceneFailure, ranges) {
    const std::string bytes = std::to_string(square().bin.size());
    EXPECT_EQ(spoiled([](Json& j) { j["bufferViews"][0]["byteLength"] = 9007199254740991; }),
              "bufferViews[0] reaches beyond its buffer: 9007199254740991 bytes from byte 0, the "
              "buffer has " +
                  bytes);
    EXPECT_EQ(
        spoiled([](Json& j) { j["accessors"][0]["count"] = 9007199254740991; }),
        "meshes[0].primitives[0] brings 9007199254740991 more vertices, expected at most 33554432");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][3]["count"] = 1000000; }),
              "accessors[3] reaches beyond bufferViews[3]: 1000000 elements of 2 bytes, 2 apart, "
              "from byte 0, the view has 12");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][0]["byteOffset"] = 4; }),
              "accessors[0] reaches beyond bufferViews[0]: 4 elements of 12 bytes, 12 apart, from "
              "byte 4, the view has 48");
    EXPECT_EQ(spoiled([](Json& j) { j["bufferViews"][0]["byteStride"] = 8; }),
              "bufferViews[0].byteStride is 8, expected at least 12 for accessors[0]");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][0].erase("bufferView"); }),
              "accessors[0] has no bufferView, expected one for its 4 elements");
    // tinygltf finds this one.
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][3].erase("bufferView"); }),
              "tinygltf: accessor[3] invalid bufferView");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][1]["count"] = 3; }),
              "meshes[0].primitives[0].NORMAL has 3 elements, expected as many as POSITION, 4");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][0]["type"] = "VEC2"; }),
              "accessors[0].type does not fit its use, expected VEC3");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][0]["componentType"] = 5125; }),
              "accessors[0].componentType is 5125, expected 5126 (float) or a byte or short type");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][3]["componentType"] = 5122; }),
              "accessors[3] cannot hold indices, expected SCALAR of 5121, 5123 or 5125");
    EXPECT_EQ(spoiled([](Json& j) { j["accessors"][3]["count"] = 5; }),
              "meshes[0].primitives[0] draws 5 vertices, expected a multiple of 3");
    EXPECT_EQ(spoiled([](Json& j) {
                  j["accessors"][3]["count"] = 2, j["meshes"][0]["primitives"][0]["mode"] = 5;
              }),
              "meshes[0].primitives[0] draws 2 vertices, expected at least 3");
}

TEST(SceneFailure, sparse) {
    const auto sparse = [](const std::function<void(Json&)>& spoil) {
        GltfBuilder builder = sparseSquare();
        spoil(builder.json["accessors"][0]);
        return reasonOf(builder.glb());
    };
    EXPECT_EQ(sparse([](Json& a) { a["sparse"]["count"] = 5; }),
              "accessors[0].sparse.count is 5, expected at most the accessor's count 4");
    EXPECT_EQ(sparse([](Json& a) { a["sparse"]["count"] = 3; }),
              "accessors[0].sparse.indices reaches beyond bufferViews[4]: 3 elements of 2 bytes, 2 "
              "apart, from byte 0, the view has 4");
    EXPECT_EQ(sparse([](Json& a) { a["sparse"]["values"]["byteOffset"] = 4294967296; }),
              "accessors[0].sparse.values.byteOffset is 4294967296, expected an integer from 0 to "
              "2147483647");
    EXPECT_EQ(sparse([](Json& a) {
                  a["sparse"]["indices"]["bufferView"] = 0,
                  a["sparse"]["indices"]["byteOffset"] = 12;
              }),
              "accessors[0].sparse.indices holds 16256, expected below the accessor's count 4");
    EXPECT_EQ(sparse([](Json& a) { a.erase("bufferView"), a["count"] = 1000000; }),
              "accessors[0] has no bufferView, expected one for its 1000000 elements");
    EXPECT_EQ(sparse([](Json& a) { a["sparse"].erase("values"); }),
              "accessors[0].sparse.values is missing, glTF 2.0 requires it");
}

TEST(SceneFailure, contents) {
    GltfBuilder builder = square();
    builder.json["meshes"][0]["primitives"][0]["indices"] =
        builder.indices<std::uint8_t>({0, 1, 4}, kUnsignedByte);
    EXPECT_EQ(reasonOf(builder.glb()),
              "meshes[0].primitives[0] has index 4, expected below the number of vertices, 4");
    builder = square();
    builder.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
        builder.floats({0, 0, 0, 1, 0, 0, INFINITY, 1, 0, 0, 1, 0}, "VEC3");
    EXPECT_EQ(reasonOf(builder.glb()),
              "meshes[0].primitives[0].POSITION holds a vertex that is not finite, number 2");
    const std::string nothing =
        "nothing to draw, expected a scene with a node that has a mesh of triangles";
    EXPECT_EQ(spoiled([](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 1; }), nothing);
    EXPECT_EQ(
        spoiled([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }),
        nothing);
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"][0]["scale"] = {0, 0, 0}; }), nothing);
}

TEST(SceneFailure, nodes) {
    const std::string twice = " is reached twice, expected a tree without cycles or shared nodes";
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"][0]["children"] = {0}; }), "nodes[0]" + twice);
    EXPECT_EQ(spoiled([](Json& j) { j["scenes"][0]["nodes"] = {0, 0}; }), "nodes[0]" + twice);
    EXPECT_EQ(spoiled([](Json& j) { j.erase("scenes"), j["nodes"][0]["children"] = {0}; }),
              "nodes form a cycle, expected a tree");
    const auto chain = [](std::size_t length) {
        return [length](Json& j) {
            for (std::size_t i = 1; i < length; ++i) j["nodes"].push_back({{"children", {i + 1}}});
            j["nodes"].push_back(Json::object());
            j["nodes"][0]["children"] = {1};
        };
    };
    EXPECT_EQ(spoiled(chain(255)), "no failure");
    EXPECT_EQ(spoiled(chain(256)), "nodes[256] is nested deeper than 256 levels, expected fewer");
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"][0]["rotation"] = {0, 0, 0, 0}; }),
              "nodes[0].rotation has length 0.000000, expected a unit quaternion");
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"][0]["matrix"] = {1, 2}; }),
              "nodes[0].matrix has 2 elements, expected an array of 16 numbers");
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"][0]["scale"] = {1, "2", 3}; }),
              "nodes[0].scale[1] is of type string, expected a number");
    EXPECT_EQ(spoiled([](Json& j) {
                  j["nodes"][0]["scale"] = {1e300, 1, 1}, j["nodes"][0]["children"] = {1};
                  j["nodes"].push_back({{"mesh", 0}, {"scale", {1e300, 1, 1}}});
              }),
              "nodes[1] has a transform to the world that is not finite");
    EXPECT_EQ(spoiled([](Json& j) { j["nodes"][0]["translation"] = {1e20, 0, 0}; }),
              "scene reaches too far out, expected coordinates within 1e18");
}

TEST(SceneFailure, bombs) {
    // Many primitives on one accessor, and many nodes on one mesh.
    GltfBuilder builder = square();
    builder.bin.resize(1 << 20);
    builder.json["bufferViews"][0] = {{"buffer", 0}, {"byteLength", 1 << 20}};
    builder.json["accessors"][0]["count"] = 80000;
    Json& primitives = builder.json["meshes"][0]["primitives"];
    primitives[0] = {{"attributes", {{"POSITION", 0}}}, {"mode", 6}};
    for (int i = 0; i < 200; ++i) primitives.push_back(primitives[0]);
    // Each takes 80000 for its array and three times that for flat shading, out of 33554432.
    EXPECT_EQ(reasonOf(builder.glb()),
              "meshes[0].primitives[104] brings 240000 more vertices, expected at most 194432");

    builder = square();
    for (int i = 0; i < 1100; ++i) {
        builder.json["meshes"][0]["primitives"].push_back(
            builder.json["meshes"][0]["primitives"][0]);
        builder.rootNode({{"mesh", 0}});
    }
    EXPECT_EQ(reasonOf(builder.glb()), "scene has too many instances, expected at most 1048576");
}

TEST(SceneFailure, brokenFiles) {
    const std::string folder = NACRE_TEST_DATA;
    EXPECT_EQ(loadScene(folder + "/broken-buffer-index.gltf").error().message,
              "cannot load '" + folder +
                  "/broken-buffer-index.gltf': bufferViews[1].buffer is 1, "
                  "expected an index below 1, the number of buffers");
    EXPECT_EQ(loadScene(folder + "/broken-integer-out-of-bounds.gltf").error().message,
              "cannot load '" + folder +
                  "/broken-integer-out-of-bounds.gltf': bufferViews[0].byteLength is 1e+300, "
                  "expected an integer from 1 to 9007199254740991");
}

/// Replaces one value somewhere in the document, or removes it.
void mutateJson(Json& document, std::mt19937& random) {
    static const std::vector<Json> values = {nullptr,
                                             true,
                                             0,
                                             1,
                                             2,
                                             3,
                                             5,
                                             7,
                                             12,
                                             255,
                                             65536,
                                             -1,
                                             0.5,
                                             1e9,
                                             1e300,
                                             -1e300,
                                             4294967295u,
                                             2147483648u,
                                             9223372036854775807,
                                             18446744073709551615u,
                                             "",
                                             "VEC2",
                                             "SCALAR",
                                             "data:;base64,AAAA",
                                             Json::array(),
                                             Json::object(),
                                             {0},
                                             {0, 0, 0, 0},
                                             {1e38, 1e-38, 1},
                                             5121,
                                             5123,
                                             5125,
                                             5126};
    Json* at = &document;
    while (at->is_structured() && !at->empty() && (at == &document || random() % 16 != 0)) {
        auto member = at->begin();
        std::advance(member, static_cast<std::ptrdiff_t>(random() % at->size()));
        if (random() % 100 == 0) {
            at->erase(member);
            return;
        }
        at = &*member;
    }
    *at = values[random() % values.size()];
}

TEST(SceneFuzz, neverFailsBadly) {
    constexpr int rounds = NACRE_FUZZ_ROUNDS;
    GltfBuilder base = sparseSquare();
    base.rootNode({{"mesh", 0},
                   {"rotation", {0, 0.6, 0, 0.8}},
                   {"scale", {1, -2, 1}},
                   {"translation", {1, 2, 3}}});
    base.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] =
        base.floats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
    base.json["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", 0}}}, {"mode", 5}});
    const TemporaryDirectory directory;
    std::mt19937 random(20240607);
    int scenes = 0;
    for (int round = 0; round < rounds; ++round) {
        GltfBuilder builder = base;
        const bool isBinary = random() % 2 == 0;
        const auto kind =
            random() % 8 == 0 ? 2 : random() % 2 * 3;  // 0: values, 2: truncation, 3: bytes
        for (auto n = random() % 2 + 1; kind == 0 && n > 0; --n) mutateJson(builder.json, random);
        std::string bytes = isBinary ? builder.glb() : builder.gltf();
        if (kind == 2) bytes.resize(random() % bytes.size());
        // The binary chunk of a GLB is its last part: most flips go there.
        const std::size_t from =
            isBinary && random() % 4 != 0 ? bytes.size() - builder.bin.size() : 0;
        for (auto n = random() % 4 + 1; kind == 3 && n > 0; --n) {
            bytes[from + random() % (bytes.size() - from)] = static_cast<char>(random());
        }
        const auto scene = loadScene(directory.write("mutant", bytes));
        if (scene) {
            ++scenes;
            ASSERT_TRUE(isSound(*scene)) << "round " << round;
        } else {
            ASSERT_EQ(scene.error().message.find('\n'), std::string::npos) << "round " << round;
            ASSERT_LT(scene.error().message.size(), 1000u) << "round " << round;
        }
    }
    // Mutants that all fail would test the checks only, mutants that all load none of them.
    EXPECT_GT(scenes, rounds / 10);
    EXPECT_LT(scenes, rounds * 9 / 10);
}

}  // namespace
