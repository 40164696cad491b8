#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

/// Small glTF documents made in code, and a directory to put them in.
namespace nacre::test {

using Json = nlohmann::json;

/// A fresh directory that goes away with its contents.
class TemporaryDirectory {
public:
    TemporaryDirectory() {
        std::string name = (std::filesystem::temp_directory_path() / "nacre-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), name);
        path_ = name;
    }
    ~TemporaryDirectory() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path_ / name, std::ios::binary) << bytes;
        return path_ / name;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

enum ComponentType {
    kByte = 5120,
    kUnsignedByte,
    kShort,
    kUnsignedShort,
    kUnsignedInt = 5125,
    kFloat
};

template <class T>
std::string bytesOf(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// Grows a document; `json` is there to be spoiled before it is written.
struct GltfBuilder {
    Json json = {{"asset", {{"version", "2.0"}}}};
    std::string bin;

    /// A view of the bytes; the index of it.
    std::size_t view(const std::string& bytes, std::size_t stride = 0) {
        bin.resize((bin.size() + 3) / 4 * 4);
        Json view = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
        if (stride) view["byteStride"] = stride;
        bin += bytes;
        json["bufferViews"].push_back(view);
        return json["bufferViews"].size() - 1;
    }

    std::size_t accessor(std::size_t view, ComponentType component, std::size_t count,
                         const char* type) {
        json["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        return json["accessors"].size() - 1;
    }

    /// An accessor of floats with a view of its own.
    std::size_t floats(const std::vector<float>& values, const char* type) {
        const std::size_t components = type[0] == 'S' ? 1 : static_cast<std::size_t>(type[3] - '0');
        return accessor(view(bytesOf(values)), kFloat, values.size() / components, type);
    }

    template <class T>
    std::size_t indices(const std::vector<T>& values, ComponentType component) {
        return accessor(view(bytesOf(values)), component, values.size(), "SCALAR");
    }

    /// A mesh of one primitive; the index of it.
    std::size_t mesh(const Json& primitive) {
        json["meshes"].push_back({{"primitives", {primitive}}});
        return json["meshes"].size() - 1;
    }

    /// The node becomes a root of the only scene.
    std::size_t rootNode(const Json& node) {
        json["nodes"].push_back(node);
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
        return json["nodes"].size() - 1;
    }

    std::string glb(std::string text = "") const {
        Json document = json;
        if (!bin.empty() && !document.contains("buffers")) {
            document["buffers"] = {{{"byteLength", bin.size()}}};
        }
        if (text.empty()) text = document.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string padded = bin;
        padded.resize((padded.size() + 3) / 4 * 4);
        const auto u32 = [](std::size_t value) {
            return bytesOf(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)});
        };
        std::string chunks = u32(text.size()) + "JSON" + text;
        if (!bin.empty()) chunks += u32(padded.size()) + std::string("BIN\0", 4) + padded;
        return "glTF" + u32(2) + u32(12 + chunks.size()) + chunks;
    }

    std::string gltf() const {
        static const char* digits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bin.size(); i += 3) {
            std::uint32_t word = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                word =
                    word << 8 | (i + k < bin.size() ? static_cast<unsigned char>(bin[i + k]) : 0u);
            }
            for (std::size_t k = 0; k < 4; ++k) {
                text += i + k > bin.size() ? '=' : digits[word >> (18 - 6 * k) & 63];
            }
        }
        Json document = json;
        if (!document.contains("buffers")) {
            document["buffers"] = {{{"byteLength", bin.size()},
                                    {"uri", "data:application/gltf-buffer;base64," + text}}};
        }
        return document.dump();
    }
};

/// The unit square in the plane z = 0, facing +Z: normals, texture coordinates with the image's up
/// along +Y, indices of two triangles, one node.
inline GltfBuilder square() {
    GltfBuilder builder;
    builder.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    builder.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    builder.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
    builder.indices<std::uint16_t>({0, 1, 2, 0, 2, 3}, kUnsignedShort);
    builder.mesh(
        {{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}}, {"indices", 3}});
    builder.rootNode({{"mesh", 0}});
    return builder;
}

}  // namespace nacre::test
