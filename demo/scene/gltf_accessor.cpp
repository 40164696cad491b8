#include "gltf_accessor.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "load_failure.hpp"

namespace nacre::demo {

namespace {

std::string named(const char* array, int index) {
    return std::string(array) + '[' + std::to_string(index) + ']';
}

std::size_t componentBytes(int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return 2;
        default: return 4;
    }
}

/// Elements that lie in a buffer from first to last.
struct Elements {
    const unsigned char* first;
    std::size_t stride;
    const unsigned char* operator[](std::size_t i) const { return first + i * stride; }
};

/// Checks by subtraction and division, which cannot overflow whatever the file claims.
Elements elementsOf(const tinygltf::Model& model, int viewIndex, std::size_t byteOffset,
                    std::size_t count, std::size_t elementBytes, const std::string& accessor) {
    const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(viewIndex));
    const std::string viewName = named("bufferViews", viewIndex);
    const auto& buffer = model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
        throw LoadFailure(viewName +
                          " reaches beyond its buffer: " + std::to_string(view.byteLength) +
                          " bytes from byte " + std::to_string(view.byteOffset) +
                          ", the buffer has " + std::to_string(buffer.size()));
    }
    const std::size_t stride = view.byteStride ? view.byteStride : elementBytes;
    if (stride < elementBytes) {
        throw LoadFailure(viewName + ".byteStride is " + std::to_string(stride) +
                          ", expected at least " + std::to_string(elementBytes) + " for " +
                          accessor);
    }
    const std::size_t room = byteOffset < view.byteLength ? view.byteLength - byteOffset : 0;
    if (room < elementBytes || count - 1 > (room - elementBytes) / stride) {
        throw LoadFailure(accessor + " reaches beyond " + viewName + ": " + std::to_string(count) +
                          " elements of " + std::to_string(elementBytes) + " bytes, " +
                          std::to_string(stride) + " apart, from byte " +
                          std::to_string(byteOffset) + ", the view has " +
                          std::to_string(view.byteLength));
    }
    return {buffer.data() + view.byteOffset + byteOffset, stride};
}

/// Calls `store(i, bytes)` for each element: from the view, then from the sparse replacements.
/// `prepare()` comes before, after all ranges have been found valid.
template <class Prepare, class Store>
void readElements(const tinygltf::Model& model, int index, std::size_t components,
                  const Prepare& prepare, const Store& store) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
    const std::string name = named("accessors", index);
    const std::size_t elementBytes = components * componentBytes(accessor.componentType);

    const bool hasView = accessor.bufferView >= 0;
    Elements elements{};
    if (hasView) {
        elements = elementsOf(model, accessor.bufferView, accessor.byteOffset, accessor.count,
                              elementBytes, name);
    } else {
        // All zeros but for the sparse values: no view bounds the count, so the file's size does.
        std::size_t bytes = 0;
        for (const auto& buffer : model.buffers) bytes += buffer.data.size();
        if (!accessor.sparse.isSparse || accessor.count > bytes) {
            throw LoadFailure(name + " has no bufferView, expected one for its " +
                              std::to_string(accessor.count) + " elements");
        }
    }

    const auto& sparse = accessor.sparse;
    const std::size_t replacements = sparse.isSparse ? static_cast<std::size_t>(sparse.count) : 0;
    Elements places{}, values{};
    if (replacements > 0) {
        if (replacements > accessor.count) {
            throw LoadFailure(name + ".sparse.count is " + std::to_string(replacements) +
                              ", expected at most the accessor's count " +
                              std::to_string(accessor.count));
        }
        places = elementsOf(model, sparse.indices.bufferView,
                            static_cast<std::size_t>(sparse.indices.byteOffset), replacements,
                            componentBytes(sparse.indices.componentType), name + ".sparse.indices");
        values = elementsOf(model, sparse.values.bufferView,
                            static_cast<std::size_t>(sparse.values.byteOffset), replacements,
                            elementBytes, name + ".sparse.values");
    }

    prepare();
    for (std::size_t i = 0; hasView && i < accessor.count; ++i) store(i, elements[i]);
    for (std::size_t i = 0; i < replacements; ++i) {
        std::uint32_t place = 0;  // little-endian: the bytes that are not copied are the high ones
        std::memcpy(&place, places[i], componentBytes(sparse.indices.componentType));
        if (place >= accessor.count) {
            throw LoadFailure(name + ".sparse.indices holds " + std::to_string(place) +
                              ", expected below the accessor's count " +
                              std::to_string(accessor.count));
        }
        store(place, values[i]);
    }
}

template <class T>
float decoded(const unsigned char* bytes, float scale) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    // glTF 2.0, section 3.11: -128 stands for -1, just as -127 does.
    return scale == 1.0f ? static_cast<float>(value)
                         : std::max(static_cast<float>(value) / scale, -1.0f);
}

float readComponent(const unsigned char* bytes, int componentType, bool normalized) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return decoded<std::int8_t>(bytes, normalized ? 127.0f : 1.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return decoded<std::uint8_t>(bytes, normalized ? 255.0f : 1.0f);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return decoded<std::int16_t>(bytes, normalized ? 32767.0f : 1.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return decoded<std::uint16_t>(bytes, normalized ? 65535.0f : 1.0f);
        default: return decoded<float>(bytes, 1.0f);
    }
}

}  // namespace

std::size_t accessorCount(const tinygltf::Model& model, int accessor) {
    return model.accessors.at(static_cast<std::size_t>(accessor)).count;
}

template <int components>
std::vector<glm::vec<components, float>> readVectors(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
    // TINYGLTF_TYPE_VEC2 … VEC4 are 2 … 4.
    if (accessor.type != components) {
        throw LoadFailure(named("accessors", index) + ".type does not fit its use, expected VEC" +
                          std::to_string(components));
    }
    const int type = accessor.componentType;
    if (type == TINYGLTF_COMPONENT_TYPE_INT || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
        throw LoadFailure(named("accessors", index) + ".componentType is " + std::to_string(type) +
                          ", expected 5126 (float) or a byte or short type");
    }
    std::vector<glm::vec<components, float>> vectors;
    readElements(
        model, index, components, [&] { vectors.resize(accessor.count); },
        [&](std::size_t i, const unsigned char* bytes) {
            for (int c = 0; c < components; ++c) {
                vectors[i][c] = readComponent(bytes, type, accessor.normalized);
                bytes += componentBytes(type);
            }
        });
    return vectors;
}

template std::vector<glm::vec2> readVectors<2>(const tinygltf::Model&, int);
template std::vector<glm::vec3> readVectors<3>(const tinygltf::Model&, int);
template std::vector<glm::vec4> readVectors<4>(const tinygltf::Model&, int);

std::vector<std::uint32_t> readIndices(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
    const int type = accessor.componentType;
    const bool isUnsigned = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                            type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                            type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!isUnsigned || accessor.type != TINYGLTF_TYPE_SCALAR) {
        throw LoadFailure(named("accessors", index) +
                          " cannot hold indices, expected SCALAR of 5121, 5123 or 5125");
    }
    std::vector<std::uint32_t> indices;
    readElements(
        model, index, 1, [&] { indices.resize(accessor.count); },
        [&](std::size_t i, const unsigned char* bytes) {
            std::uint32_t value = 0;
            std::memcpy(&value, bytes, componentBytes(type));
            indices[i] = value;
        });
    return indices;
}

}  // namespace nacre::demo
