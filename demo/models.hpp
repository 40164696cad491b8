#pragma once

#include <filesystem>

namespace nacre::demo {

/// The glTF file that ships with the demo: beside an installed nacre-render, else in the source tree.
std::filesystem::path shippedModel();

}  // namespace nacre::demo
