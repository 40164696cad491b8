#include "gltf_model.hpp"

#include <tiny_gltf.h>

#include <limits>

#include "glb.hpp"
#include "gltf_check.hpp"
#include "input_file.hpp"
#include "load_failure.hpp"

namespace nacre::demo {

namespace {

// tinygltf counts the characters of base64 in int.
constexpr std::uint64_t kMostFileBytes = std::numeric_limits<int>::max();

// Parsed JSON takes up to about ten times its text.
constexpr std::uint64_t kMostJsonBytes = std::uint64_t{1} << 28;

constexpr const char* kExpected = "a .gltf or .glb file";

std::string readDocument(const std::filesystem::path& file) {
    InputFile input(file, kExpected);
    if (input.size() > kMostFileBytes) {
        throw LoadFailure("file has " + std::to_string(input.size()) + " bytes, expected at most " +
                          std::to_string(kMostFileBytes));
    }
    std::string bytes(static_cast<std::size_t>(input.size()), '\0');
    input.read(bytes.data(), bytes.size());
    return bytes;
}

Glb findJson(std::string_view bytes) {
    if (isGlb(bytes)) return splitGlb(bytes);
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    std::string_view text = bytes;
    if (text.substr(0, byteOrderMark.size()) == byteOrderMark) {
        text.remove_prefix(byteOrderMark.size());
    }
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == text.npos || text[start] != '{') {
        throw LoadFailure("is not glTF: expected it to start with 'glTF' or '{'");
    }
    return {text, {}};
}

/// The files of a document's buffers, for tinygltf to ask for by number.
struct BufferFolder {
    std::filesystem::path folder;
    const std::vector<BufferFile>& files;
};

bool readBufferFile(std::vector<unsigned char>* bytes, std::string*, const std::string& number,
                    void* userData) {
    const auto& buffers = *static_cast<const BufferFolder*>(userData);
    const BufferFile& file = buffers.files.at(std::stoul(number));
    try {
        InputFile input(buffers.folder / file.path, "the bytes of a buffer");
        if (input.size() < file.byteLength) {
            throw LoadFailure("file has " + std::to_string(input.size()) +
                              " bytes, expected at least the buffer's byteLength " +
                              std::to_string(file.byteLength));
        }
        // A longer file is allowed, but tinygltf insists on the exact size.
        bytes->resize(static_cast<std::size_t>(file.byteLength));
        input.read(bytes->data(), bytes->size());
    } catch (const LoadFailure& failure) {
        throw LoadFailure("buffer file '" + quotable(file.path) + "': " + failure.what());
    }
    return true;
}

}  // namespace

tinygltf::Model readModel(const std::filesystem::path& file) {
    std::string bytes = readDocument(file);
    Glb glb = findJson(bytes);
    if (glb.json.size() > kMostJsonBytes) {
        throw LoadFailure("JSON has " + std::to_string(glb.json.size()) +
                          " bytes, expected at most " + std::to_string(kMostJsonBytes));
    }
    // The document is checked and reduced first: tinygltf 2.7 casts numbers without looking, reads
    // past a BIN chunk that ends with the file, and fails when a texture is missing.
    const CheckedDocument document =
        checkDocument(parseJson(glb.json), {!glb.bin.empty(), glb.bin.size()});
    const std::string json = document.json.dump();
    if (json.size() > std::numeric_limits<unsigned int>::max()) {
        throw LoadFailure("JSON takes " + std::to_string(json.size()) +
                          " bytes without abbreviations, expected at most 4294967295");
    }

    BufferFolder folder{file.parent_path(), document.bufferFiles};
    tinygltf::FsCallbacks files{};
    files.FileExists = [](const std::string&, void*) { return true; };  // reading tells
    files.ExpandFilePath = [](const std::string& path, void*) { return path; };
    files.ReadWholeFile = readBufferFile;
    files.user_data = &folder;
    tinygltf::TinyGLTF reader;
    reader.SetFsCallbacks(files);

    tinygltf::Model model;
    std::string error, warning;
    bool read = false;
    if (isGlb(bytes)) {
        const std::string binary = joinGlb({json, glb.bin});
        std::string().swap(bytes);  // its bytes are in `binary` now, and soon in the model
        read = reader.LoadBinaryFromMemory(&model, &error, &warning,
                                           reinterpret_cast<const unsigned char*>(binary.data()),
                                           static_cast<unsigned int>(binary.size()), "");
    } else {
        read = reader.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                          static_cast<unsigned int>(json.size()), "");
    }
    // tinygltf reports in several lines and quotes what it read, at any length.
    if (!read) throw LoadFailure("tinygltf: " + quotable(error));
    return model;
}

}  // namespace nacre::demo
