// What the loader makes of good glTF.

#include <glm/trigonometric.hpp>
#include <limits>

#include "scene_loading.hpp"

namespace {

using namespace nacre::test;

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

}  // namespace
