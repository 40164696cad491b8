#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace nacre::demo {

/// Ends a load, with the reason as its text. It stays inside the loader: json and the containers
/// throw anyway, so one way out serves them all, and loadScene() turns it into an Error.
struct LoadFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Text from a file, such as a name, fit for a message of one line: control characters become
/// spaces, and its length is bounded.
std::string quotable(std::string_view text);

}  // namespace nacre::demo
