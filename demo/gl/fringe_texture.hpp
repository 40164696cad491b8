#pragma once

#include <nacre/fringe_table.hpp>

#include "functions.hpp"

namespace nacre::demo {

/// The fringe table as a texture, filtered and clamped as the shaders expect it; bound to the active unit. The
/// caller deletes it.
GLuint makeFringeTexture(const GlFunctions& gl, const FringeTable& table);

}  // namespace nacre::demo
