#include "text_file.hpp"

#include <fstream>
#include <sstream>

namespace nacre::bench {

Result<std::string> readText(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    if (!(stream && text << stream.rdbuf())) return Error{"cannot read " + path.string()};
    return text.str();
}

Result<std::string> writeText(const std::filesystem::path& path, const std::string& text)
{
    std::ofstream stream(path, std::ios::binary);
    if (!(stream << text << std::flush)) return Error{"cannot write " + path.string()};
    return text;
}

Result<std::string> readGlsl(const char* file)
{
    return readText(std::filesystem::path(NACRE_BENCH_GLSL_DIR) / file);
}

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) text.replace(at, what.size(), with);
    return text;
}

Result<std::string> withIncludes(std::string text, const std::string& open, char close,
                                 const std::function<Result<std::string>(const std::string& name)>& load)
{
    for (std::size_t at = 0; (at = text.find(open, at)) != std::string::npos;) {
        const std::size_t name = at + open.size(), end = text.find(close, name);
        if (end == std::string::npos) return Error{"an include without an end: " + text.substr(at, 80)};
        Result<std::string> included = load(text.substr(name, end - name));
        if (!included) return included;
        text.replace(at, end + 1 - at, *included);
        at += included->size();
    }
    return text;
}

}  // namespace nacre::bench
