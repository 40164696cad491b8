#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace nacre::demo {

/// A regular file that is open for reading. Pipes and devices are refused: they have no size to
/// check against, and reading them may never end.
class InputFile {
public:
    /// `expected` ends each message: what the file should have been. Throws LoadFailure.
    InputFile(const std::filesystem::path& file, std::string_view expected);

    std::uint64_t size() const { return size_; }

    /// The next bytes of the file; throws LoadFailure when there are fewer.
    void read(void* destination, std::size_t bytes);

private:
    std::ifstream stream_;
    std::uint64_t size_ = 0;
};

}  // namespace nacre::demo
