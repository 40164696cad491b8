#include "functions.hpp"

#include <string>

namespace nacre::demo {

Result<GlFunctions> GlFunctions::load(GetProcAddress getProcAddress)
{
    GlFunctions gl;
#define NACRE_GL_LOAD(type, name)                                  \
    gl.name = reinterpret_cast<type>(getProcAddress("gl" #name)); \
    if (!gl.name) return Error{"the OpenGL driver lacks gl" #name "; OpenGL 3.3 is needed"};
    NACRE_GL_FUNCTIONS(NACRE_GL_LOAD)
#undef NACRE_GL_LOAD
    return gl;
}

}  // namespace nacre::demo
