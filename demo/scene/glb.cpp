#include "glb.hpp"

#include <cstdint>
#include <limits>

#include "load_failure.hpp"

namespace nacre::demo {

namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kHeaderBytes = 12;      // magic, version, length
constexpr std::size_t kChunkHeaderBytes = 8;  // length, type
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinChunk = 0x004E4942;

std::uint32_t littleEndian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

void appendLittleEndian(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

/// Takes the chunk at the front of `rest` off it.
std::string_view takeChunk(std::string_view& rest, std::uint32_t& type) {
    const auto truncated = [](std::size_t needed, std::size_t has) {
        throw LoadFailure("chunk is truncated: needs " + std::to_string(needed) +
                          " bytes, the file's header leaves " + std::to_string(has));
    };
    if (rest.size() < kChunkHeaderBytes) truncated(kChunkHeaderBytes, rest.size());
    const std::size_t length = littleEndian(rest, 0);
    type = littleEndian(rest, 4);
    rest.remove_prefix(kChunkHeaderBytes);
    if (length > rest.size()) truncated(length, rest.size());
    const auto chunk = rest.substr(0, length);
    rest.remove_prefix(length);
    return chunk;
}

void appendChunk(std::string& bytes, std::uint32_t type, std::string_view chunk, char filler) {
    const std::size_t padding = (4 - chunk.size() % 4) % 4;
    appendLittleEndian(bytes, static_cast<std::uint32_t>(chunk.size() + padding));
    appendLittleEndian(bytes, type);
    bytes += chunk;
    bytes.append(padding, filler);
}

}  // namespace

bool isGlb(std::string_view file) { return file.substr(0, kMagic.size()) == kMagic; }

Glb splitGlb(std::string_view file) {
    if (file.size() < kHeaderBytes) {
        throw LoadFailure("file is truncated: a GLB header has 12 bytes, file has " +
                          std::to_string(file.size()));
    }
    const std::uint32_t version = littleEndian(file, 4);
    if (version != 2) {
        throw LoadFailure("GLB version is " + std::to_string(version) + ", expected 2");
    }
    const std::size_t length = littleEndian(file, 8);
    if (length > file.size()) {
        throw LoadFailure("file is truncated: header says " + std::to_string(length) +
                          " bytes, file has " + std::to_string(file.size()));
    }
    if (length < kHeaderBytes) {
        throw LoadFailure("GLB header says " + std::to_string(length) +
                          " bytes, expected at least 12");
    }

    std::string_view rest = file.substr(kHeaderBytes, length - kHeaderBytes);
    std::uint32_t type = 0;
    Glb glb;
    glb.json = takeChunk(rest, type);
    if (type != kJsonChunk) {
        throw LoadFailure("first GLB chunk has type " + std::to_string(type) +
                          ", expected 1313821514 (JSON)");
    }
    // Chunks of other types are for extensions, which the specification tells readers to pass over.
    if (!rest.empty()) {
        const auto chunk = takeChunk(rest, type);
        if (type == kBinChunk) glb.bin = chunk;
    }
    return glb;
}

std::string joinGlb(const Glb& glb) {
    const std::uint64_t length = std::uint64_t{kHeaderBytes} + 2 * kChunkHeaderBytes +
                                 glb.json.size() + glb.bin.size() + 6;  // at most 3 + 3 of padding
    if (length > std::numeric_limits<std::uint32_t>::max()) {
        throw LoadFailure("document takes " + std::to_string(length) +
                          " bytes, expected at most 4294967295");
    }
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(length));
    bytes += kMagic;
    appendLittleEndian(bytes, 2);
    appendLittleEndian(bytes, 0);  // the length, once it is known
    appendChunk(bytes, kJsonChunk, glb.json, ' ');
    if (!glb.bin.empty()) appendChunk(bytes, kBinChunk, glb.bin, '\0');

    std::string total;
    appendLittleEndian(total, static_cast<std::uint32_t>(bytes.size()));
    bytes.replace(8, 4, total);
    return bytes;
}

}  // namespace nacre::demo
