#pragma once

#include <nacre/uniforms.hpp>

namespace nacre::test {

/// The OpenGL functions that nacre::Uniforms asks for, doing nothing: what is left is the library's own time.
GetProcAddress nullGl();

/// How many values they were given so far.
long nullGlCalls();

}  // namespace nacre::test
