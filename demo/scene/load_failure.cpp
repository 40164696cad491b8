#include "load_failure.hpp"

namespace nacre::demo {

std::string quotable(std::string_view text) {
    constexpr std::size_t most = 200;
    std::string line(text);
    if (line.size() > most) {
        std::size_t end = most;
        // Not within a character of UTF-8, whose further bytes are 10xxxxxx.
        while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) --end;
        line.replace(end, line.npos, "...");
    }
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = ' ';
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

}  // namespace nacre::demo
