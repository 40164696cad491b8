#include "text_file.hpp"

#include <unistd.h>

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
    // Beside it first: under its name stands the old file or the whole new one. What is no file, a terminal or
    // a pipe, is written to as it is.
    namespace fs = std::filesystem;
    std::error_code error, ignored;
    const bool isFile = !fs::exists(path, ignored) || fs::is_regular_file(path, ignored);
    const fs::path target = isFile && fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
    fs::path partial = target;
    if (isFile) partial.replace_filename(".nacre-" + std::to_string(getpid()) + ".partial");
    std::ofstream stream(partial, std::ios::binary);
    stream << text;
    stream.close();
    if (isFile && stream) fs::rename(partial, target, error);
    if (stream && !error) return text;
    if (isFile) fs::remove(partial, ignored);
    return Error{"cannot write " + path.string()};
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
