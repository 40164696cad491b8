#include "version.hpp"

#include <cctype>

namespace nacre::demo {

Outcome setVersion(GlslOptions& options, const std::string& text)
{
    const std::size_t space = text.find(' ');
    const std::string number = text.substr(0, space), profile = space == std::string::npos ? "core" : text.substr(space + 1);
    bool isNumber = number.size() == 3;
    for (const char c : number) isNumber = isNumber && std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!isNumber || (profile != "core" && profile != "es" && profile != "vulkan")) {
        return Error{"--version: expected a version like 330, '300 es' or '450 vulkan', got '" + text + "'"};
    }
    options.version = std::stoi(number);
    options.es = profile == "es";
    options.vulkan = profile == "vulkan";
    return std::monostate{};
}

std::string versionText(const GlslOptions& options)
{
    return std::to_string(options.version) + (options.es ? " es" : options.vulkan ? " vulkan" : " core");
}

}  // namespace nacre::demo
