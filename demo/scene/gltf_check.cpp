#include "gltf_check.hpp"

#include <limits>

#include "buffer_uri.hpp"
#include "load_failure.hpp"

namespace nacre::demo {

namespace {

// glTF nests about ten levels deep, a few more inside extras. Each level costs 60 times its one
// byte of text in memory.
constexpr int kMostJsonDepth = 64;

// tinygltf keeps the offsets of sparse accessors in int.
constexpr std::uint64_t kMostSparseInteger = std::numeric_limits<int>::max();

constexpr IntegerRange kAnyOffset = {0, kMostInteger};
constexpr IntegerRange kAnyLength = {1, kMostInteger};
constexpr IntegerRange kComponentTypes = {5120, 5126};  // BYTE … FLOAT

bool startsWith(std::string_view text, std::string_view prefix) {
    return text.substr(0, prefix.size()) == prefix;
}

/// An extension may be required and yet leave positions, normals and nodes as they are: those for
/// materials, textures and lights, which this loader passes over. KHR_mesh_quantization only
/// allows more component types, all of which it reads.
bool isSupported(std::string_view extension) {
    for (const std::string_view family : {"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                          "MSFT_texture_", "KHR_lights_", "EXT_lights_"}) {
        if (startsWith(extension, family)) return true;
    }
    return extension == "KHR_mesh_quantization";
}

void checkExtensions(const CheckedObject& document) {
    const Json* required = document.find("extensionsRequired");
    if (!required) return;
    if (!required->is_array()) refuse("extensionsRequired", *required, "an array of names");
    for (const Json& name : *required) {
        if (!name.is_string()) refuse("extensionsRequired", *required, "an array of names");
        const auto& extension = name.get_ref<const std::string&>();
        if (!isSupported(extension)) {
            throw LoadFailure(
                "extension '" + quotable(extension) +
                "' is required but not supported, expected a file exported without it");
        }
    }
}

Json checkAsset(const CheckedObject& document) {
    const Json* json = document.find("asset");
    if (!json) throw LoadFailure("asset is missing, expected a glTF 2.0 document");
    const CheckedObject asset(*json, "asset");
    const std::string& version = *asset.string("version", Need::required);
    const std::string* least = asset.string("minVersion", Need::optional);
    if (!startsWith(version, "2.") || (least && *least != "2.0")) {
        throw LoadFailure("asset is of glTF version '" + quotable(least ? *least : version) +
                          "', expected '2.0'");
    }
    return {{"version", version}};
}

void checkBuffer(CheckedObject& buffer, bool isBinChunk, BinChunk bin,
                 std::vector<BufferFile>& files) {
    buffer.copyInteger("byteLength", kAnyLength, Need::required);
    const auto declared = buffer.copy()["byteLength"].get<std::uint64_t>();
    const auto requireBytes = [&](std::uint64_t bytes, const char* source) {
        if (bytes < declared) {
            throw LoadFailure(buffer.placeOf("byteLength") + " is " + std::to_string(declared) +
                              ", but its " + source + " holds " + std::to_string(bytes) + " bytes");
        }
    };

    const std::string* uri = buffer.string("uri", Need::optional);
    if (!uri) {
        if (!isBinChunk) {
            throw LoadFailure(
                buffer.placeOf("uri") +
                " is missing, only the first buffer of a GLB with a BIN chunk needs none");
        }
        requireBytes(bin.bytes, "BIN chunk");
    } else if (isDataUri(*uri)) {
        DataUri data = checkDataUri(*uri, buffer.placeOf("uri"));
        requireBytes(data.bytes, "data URI");
        buffer.set("uri", std::move(data.uri));
        buffer.set("byteLength", data.bytes);
    } else {
        buffer.set("uri", std::to_string(files.size()));
        files.push_back({percentDecoded(*uri), declared});
    }
}

void checkBufferView(CheckedObject& view, const IndexedArray& buffers) {
    view.copyIndex("buffer", buffers, Need::required);
    view.copyInteger("byteOffset", kAnyOffset, Need::optional);
    view.copyInteger("byteLength", kAnyLength, Need::required);
    view.copyInteger("byteStride", {4, 252}, Need::optional);
    if (const Json* stride = view.find("byteStride");
        stride && stride->get<std::uint64_t>() % 4 != 0) {
        refuse(view.placeOf("byteStride"), *stride, "a multiple of 4");
    }
}

Json checkSparse(const CheckedObject& accessor, const IndexedArray& views) {
    CheckedObject sparse(*accessor.find("sparse"), accessor.placeOf("sparse"));
    sparse.copyInteger("count", {1, kMostSparseInteger}, Need::required);
    for (const char* part : {"indices", "values"}) {
        const Json* json = sparse.find(part);
        if (!json) throw LoadFailure(sparse.placeOf(part) + " is missing, glTF 2.0 requires it");
        CheckedObject object(*json, sparse.placeOf(part));
        object.copyIndex("bufferView", views, Need::required);
        object.copyInteger("byteOffset", {0, kMostSparseInteger}, Need::optional);
        if (std::string_view(part) == "indices") {
            object.copyInteger("componentType", kComponentTypes, Need::required);
        }
        sparse.set(part, object.copy());
    }
    return sparse.copy();
}

void checkAccessor(CheckedObject& accessor, const IndexedArray& views) {
    accessor.copyIndex("bufferView", views, Need::optional);
    accessor.copyInteger("byteOffset", kAnyOffset, Need::optional);
    accessor.copyInteger("componentType", kComponentTypes, Need::required);
    accessor.copyInteger("count", kAnyLength, Need::required);
    accessor.copyBoolean("normalized");
    const std::string& type = *accessor.string("type", Need::required);
    for (const char* known : {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}) {
        if (type == known) accessor.set("type", type);
    }
    if (!accessor.copy().contains("type")) {
        throw LoadFailure(accessor.placeOf("type") +
                          " is unknown, expected SCALAR, VEC2 to VEC4 or MAT2 to MAT4");
    }
    if (accessor.find("sparse")) accessor.set("sparse", checkSparse(accessor, views));
}

Json checkPrimitive(const Json& json, std::string place, const IndexedArray& accessors) {
    CheckedObject primitive(json, std::move(place));
    primitive.copyIndex("indices", accessors, Need::optional);
    primitive.copyInteger("mode", {0, 6}, Need::optional);
    const Json* from = primitive.find("attributes");
    if (!from) {
        throw LoadFailure(primitive.placeOf("attributes") + " is missing, glTF 2.0 requires it");
    }
    CheckedObject attributes(*from, primitive.placeOf("attributes"));
    for (const char* name : {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0"}) {
        attributes.copyIndex(name, accessors, Need::optional);
    }
    primitive.set("attributes", attributes.copy());
    return primitive.copy();
}

void checkMesh(CheckedObject& mesh, const IndexedArray& accessors) {
    const Json* from = mesh.find("primitives");
    if (!from || !from->is_array() || from->empty()) {
        throw LoadFailure(mesh.placeOf("primitives") + " is missing or empty, expected an array");
    }
    Json primitives = Json::array();
    for (std::size_t i = 0; i < from->size(); ++i) {
        primitives.push_back(
            checkPrimitive((*from)[i], element(mesh.placeOf("primitives"), i), accessors));
    }
    mesh.set("primitives", std::move(primitives));
}

void checkNode(CheckedObject& node, const IndexedArray& meshes, const IndexedArray& nodes) {
    node.copyIndex("mesh", meshes, Need::optional);
    node.copyIndices("children", nodes);
    node.copyNumbers("matrix", 16);
    node.copyNumbers("translation", 3);
    node.copyNumbers("rotation", 4);
    node.copyNumbers("scale", 3);
}

}  // namespace

CheckedDocument checkDocument(const Json& json, BinChunk bin) {
    CheckedObject document(json, "");
    CheckedDocument checked;
    checkExtensions(document);
    checked.json = {{"asset", checkAsset(document)}};

    const auto arrayNamed = [&](const char* name) -> IndexedArray {
        const Json* array = document.find(name);
        if (array && !array->is_array()) refuse(name, *array, "an array");
        return {name, array ? array->size() : 0};
    };
    const auto checkEach = [&](const IndexedArray& array, const auto& check) {
        Json& elements = checked.json[std::string(array.name)] = Json::array();
        for (std::size_t i = 0; i < array.size; ++i) {
            CheckedObject object(json[std::string(array.name)][i], element(array.name, i));
            check(object, i);
            elements.push_back(object.copy());
        }
    };
    const auto buffers = arrayNamed("buffers"), views = arrayNamed("bufferViews"),
               accessors = arrayNamed("accessors"), meshes = arrayNamed("meshes"),
               nodes = arrayNamed("nodes"), scenes = arrayNamed("scenes");
    checkEach(buffers, [&](CheckedObject& buffer, std::size_t i) {
        checkBuffer(buffer, bin.present && i == 0, bin, checked.bufferFiles);
    });
    checkEach(views, [&](CheckedObject& view, std::size_t) { checkBufferView(view, buffers); });
    checkEach(accessors,
              [&](CheckedObject& accessor, std::size_t) { checkAccessor(accessor, views); });
    checkEach(meshes, [&](CheckedObject& mesh, std::size_t) { checkMesh(mesh, accessors); });
    checkEach(nodes, [&](CheckedObject& node, std::size_t) { checkNode(node, meshes, nodes); });
    checkEach(scenes,
              [&](CheckedObject& scene, std::size_t) { scene.copyIndices("nodes", nodes); });

    document.copyIndex("scene", scenes, Need::optional);
    if (document.copy().contains("scene")) checked.json["scene"] = document.copy()["scene"];
    return checked;
}

Json parseJson(std::string_view text) {
    const auto guardDepth = [](int depth, Json::parse_event_t, Json&) {
        if (depth > kMostJsonDepth) {
            throw LoadFailure("JSON nests deeper than " + std::to_string(kMostJsonDepth) +
                              " levels, expected a glTF document");
        }
        return true;
    };
    try {
        return Json::parse(text.begin(), text.end(), guardDepth);
    } catch (const Json::exception& failure) {
        // "[json.exception.parse_error.101] parse error at line 1, …"
        std::string reason = failure.what();
        reason.erase(0, reason.find(']') + 2);
        // It quotes the offending bytes, which need be no UTF-8.
        for (char& c : reason) {
            if (static_cast<unsigned char>(c) > '~') c = '?';
        }
        throw LoadFailure("not valid JSON: " + quotable(reason));
    }
}

}  // namespace nacre::demo
