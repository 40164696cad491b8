#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <nacre/result.hpp>

namespace nacre::bench {

Result<std::string> readText(const std::filesystem::path& path);
Result<std::string> writeText(const std::filesystem::path& path, const std::string& text);

/// A file of tests/bench/glsl.
Result<std::string> readGlsl(const char* file);

/// Replaces every occurrence.
std::string replaced(std::string text, const std::string& what, const std::string& with);

/// Replaces each `open NAME close`, `#include <NAME>` for instance, by what load(NAME) gives.
Result<std::string> withIncludes(std::string text, const std::string& open, char close,
                                 const std::function<Result<std::string>(const std::string& name)>& load);

}  // namespace nacre::bench
