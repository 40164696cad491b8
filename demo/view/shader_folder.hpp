#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nacre/glsl.hpp>
#include <nacre/result.hpp>

namespace nacre::demo {

/// The library's GLSL files read from a directory while they are worked on.
class ShaderFolder {
public:
    explicit ShaderFolder(std::filesystem::path directory) : directory_(std::move(directory)) {}

    /// Reads all files where one has changed since the last time, or they were never read; true when it did.
    /// The error names the file that cannot be read; it comes once, until something changes.
    Result<bool> update();

    /// By the names of glslFiles() in their order; valid until the next update.
    const std::vector<GlslFile>& files() const { return files_; }

private:
    std::filesystem::path directory_;
    std::vector<std::filesystem::file_time_type> times_;
    std::vector<std::string> texts_;
    std::vector<GlslFile> files_;
};

}  // namespace nacre::demo
