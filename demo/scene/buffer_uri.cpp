#include "buffer_uri.hpp"

#include <algorithm>

#include "load_failure.hpp"

namespace nacre::demo {

namespace {

// std::isalnum would ask the locale.
bool isBase64(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' ||
           c == '/';
}

/// The value of a hexadecimal digit or -1.
int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

bool isDataUri(std::string_view uri) { return uri.substr(0, 5) == "data:"; }

DataUri checkDataUri(std::string_view uri, const std::string& place) {
    constexpr std::string_view marker = ";base64,";
    const std::size_t comma = uri.find(',');
    if (comma == uri.npos || comma + 1 < marker.size() ||
        uri.substr(comma + 1 - marker.size(), marker.size()) != marker) {
        throw LoadFailure(place + " is a data URI of unknown encoding, expected base64");
    }
    std::string_view text = uri.substr(comma + 1);
    for (int padding = 0; padding < 2 && !text.empty() && text.back() == '='; ++padding) {
        text.remove_suffix(1);
    }
    const auto stray = std::find_if_not(text.begin(), text.end(), isBase64);
    if (stray != text.end()) {
        throw LoadFailure(place + " has a character at " + std::to_string(stray - text.begin()) +
                          " of its data that is none of base64");
    }
    return {"data:application/octet-stream;base64," + std::string(text),
            std::uint64_t{text.size()} * 6 / 8};
}

std::string percentDecoded(std::string_view uri) {
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escaped = uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 &&
                             hexDigit(uri[i + 2]) >= 0;
        if (escaped) {
            path += static_cast<char>(hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2]));
            i += 2;
        } else {
            path += uri[i];
        }
    }
    return path;
}

}  // namespace nacre::demo
