#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace nacre::demo {

struct DataUri {
    std::string uri;      ///< with the media type for binary data
    std::uint64_t bytes;  ///< it decodes to
};

bool isDataUri(std::string_view uri);

/// Checks that the URI holds nothing but base64, of whatever media type, so that a decoder
/// neither stops early nor has to know the type. `place` starts the message of a LoadFailure.
DataUri checkDataUri(std::string_view uri, const std::string& place);

/// A file's path from a relative URI: %20 becomes a space (RFC 3986, section 2.1).
std::string percentDecoded(std::string_view uri);

}  // namespace nacre::demo
