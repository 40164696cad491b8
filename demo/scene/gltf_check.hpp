#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "checked_json.hpp"

namespace nacre::demo {

/// A buffer kept in a file of its own.
struct BufferFile {
    std::string path;  ///< relative to the document
    std::uint64_t byteLength;
};

/// A glTF document reduced to what this loader reads, in which every value is of its kind and every
/// index within its array. A reader of it meets no image, extension or oddity that it could trip
/// over. The `uri` of an external buffer is its index in `bufferFiles`, so that the reader
/// need not know about paths.
struct CheckedDocument {
    Json json;
    std::vector<BufferFile> bufferFiles;
};

/// Whether the first buffer is the BIN chunk of a GLB, and how long that is.
struct BinChunk {
    bool present;
    std::uint64_t bytes;
};

/// Throws LoadFailure: what is wrong, where in the document, what would be right.
CheckedDocument checkDocument(const Json& document, BinChunk bin);

/// JSON text to values. Throws LoadFailure.
Json parseJson(std::string_view text);

}  // namespace nacre::demo
