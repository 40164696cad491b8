// Small files broken at random: the loader never crashes, throws or lets an unsound scene through.

#include <random>

#include "scene_loading.hpp"

// Two seconds with sanitizers; a longer search defines more.
#ifndef NACRE_FUZZ_ROUNDS
#define NACRE_FUZZ_ROUNDS 2000
#endif

namespace {

using namespace nacre::test;

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
