#pragma once

#include <string>
#include <string_view>

namespace nacre::demo {

/// What a binary glTF file holds; views into the file's bytes.
struct Glb {
    std::string_view json;
    std::string_view bin;  ///< empty when there is no BIN chunk
};

/// By content: a wrong ending is common, the magic is not.
bool isGlb(std::string_view file);

/// Finds the chunks (glTF 2.0, section 4.4). Throws LoadFailure when the file is truncated or
/// broken.
Glb splitGlb(std::string_view file);

/// The reverse of splitGlb().
std::string joinGlb(const Glb& glb);

}  // namespace nacre::demo
