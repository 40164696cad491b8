#include "shader_folder.hpp"

#include <fstream>
#include <iterator>
#include <system_error>

namespace nacre::demo {

Result<bool> ShaderFolder::update()
{
    std::vector<std::filesystem::file_time_type> times;
    for (const GlslFile& file : glslFiles()) {
        std::error_code error;
        times.push_back(std::filesystem::last_write_time(directory_ / file.name, error));
        if (error) times.back() = std::filesystem::file_time_type::min();
    }
    if (times == times_) return false;
    times_ = std::move(times);

    texts_.clear();
    files_.clear();
    for (const GlslFile& file : glslFiles()) {
        const std::filesystem::path path = directory_ / file.name;
        std::ifstream stream(path, std::ios::binary);
        texts_.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
        if (!stream || texts_.back().empty()) return Error{"cannot read the shader '" + path.string() + "'"};
    }
    for (std::size_t i = 0; i < texts_.size(); ++i) files_.push_back({glslFiles()[i].name, texts_[i]});
    return true;
}

}  // namespace nacre::demo
