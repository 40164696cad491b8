#pragma once

#include <string>
#include <vector>

#include <nacre/result.hpp>

namespace nacre::bench {

/// Runs a program found on PATH, without a shell; what it wrote to both streams. An error where it
/// cannot be started or does not exit with 0, with the line of it that names an error.
Result<std::string> run(const std::vector<std::string>& command);

}  // namespace nacre::bench
