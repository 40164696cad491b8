#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <nacre/result.hpp>

namespace nacre::demo {

/// The error's line: `cannot write 'film.png': no space left`.
Error cannotWrite(const std::filesystem::path& file, std::string why);

/// An error where there is no such directory, or what has the file's name is no file that can be replaced. Asked before the work, so that none is done in vain.
Outcome checkPlace(const std::filesystem::path& file);

/// Writes beside the target and renames: under its name stands the old file or the whole new one.
Outcome replaceFile(const std::filesystem::path& file, const void* bytes, std::size_t count);

}  // namespace nacre::demo
