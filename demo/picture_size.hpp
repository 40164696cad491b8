#pragma once

#include <sstream>
#include <string>

#include <nacre/result.hpp>

namespace nacre::demo {

struct Size {
    int width = 0, height = 0;
};

/// `1280x720`, as --size takes it.
inline Result<Size> parseSize(const std::string& text)
{
    Size size;
    char cross = 0, more = 0;
    std::istringstream stream(text);
    if (stream >> size.width >> cross >> size.height && cross == 'x' && !(stream >> more) && size.width > 0 && size.height > 0) return size;
    return Error{"--size: expected WIDTHxHEIGHT in whole numbers from 1, got '" + text + "'"};
}

}  // namespace nacre::demo
