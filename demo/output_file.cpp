#include "output_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace nacre::demo {

namespace fs = std::filesystem;

Error cannotWrite(const fs::path& file, std::string why)
{
    std::replace(why.begin(), why.end(), '\n', ' ');
    return {"cannot write '" + file.string() + "': " + why};
}

Outcome checkPlace(const fs::path& file)
{
    const fs::path directory = file.has_parent_path() ? file.parent_path() : fs::path(".");
    std::error_code ignored;
    if (!fs::is_directory(directory, ignored)) return cannotWrite(file, "there is no directory '" + directory.string() + "'");
    if (fs::is_directory(file, ignored)) return cannotWrite(file, "it is a directory");
    if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) return cannotWrite(file, "it is a device or a pipe");
    return std::monostate{};
}

Outcome replaceFile(const fs::path& file, const void* bytes, std::size_t count)
{
    std::error_code error;
    const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    fs::path partial = target;
    partial.replace_filename(".nacre-" + std::to_string(getpid()) + ".partial");
    errno = 0;
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    stream.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
    stream.close();
    error.clear();
    if (stream) fs::rename(partial, target, error);
    else error = std::error_code(errno ? errno : EIO, std::generic_category());
    if (!error) return std::monostate{};
    const std::string why = error.message();
    fs::remove(partial, error);
    return cannotWrite(file, why);
}

}  // namespace nacre::demo
