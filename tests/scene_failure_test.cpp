// What the loader says to bad glTF: one line each, pinned.

#include <sys/stat.h>
#include <limits>

#include "scene_loading.hpp"

namespace {

using namespace nacre::test;

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

}  // namespace
