#include "input_file.hpp"

#include <cerrno>
#include <string>
#include <system_error>

#include "load_failure.hpp"

namespace nacre::demo {

InputFile::InputFile(const std::filesystem::path& file, std::string_view expected) {
    const auto refuse = [&](const std::string& reason) {
        throw LoadFailure(reason + ", expected " + std::string(expected));
    };
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found) refuse("no such file");
    if (error) refuse("cannot be read: " + error.message());
    if (std::filesystem::is_directory(status)) refuse("is a directory");
    if (!std::filesystem::is_regular_file(status)) refuse("is not a regular file");

    errno = 0;
    stream_.open(file, std::ios::binary);
    if (!stream_) refuse("cannot be read: " + std::generic_category().message(errno));
    size_ = std::filesystem::file_size(file, error);
    if (error) refuse("cannot be read: " + error.message());
    if (size_ == 0) refuse("file is empty");
}

void InputFile::read(void* destination, std::size_t bytes) {
    stream_.read(static_cast<char*>(destination), static_cast<std::streamsize>(bytes));
    if (stream_.gcount() != static_cast<std::streamsize>(bytes)) {
        throw LoadFailure("reading stopped after " + std::to_string(stream_.gcount()) +
                          " bytes, expected " + std::to_string(bytes));
    }
}

}  // namespace nacre::demo
