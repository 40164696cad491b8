#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace nacre {

/// A number in a message: nine digits, the same in every locale.
inline std::string text(double value)
{
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(9);
    stream << value;
    return stream.str();
}

}  // namespace nacre
