#include "null_gl.hpp"

#include <string_view>

namespace nacre::test {
namespace {

long calls = 0;
int locations = 0;

unsigned char isProgram(unsigned int) { return 1; }
void getProgramiv(unsigned int, unsigned int, int* value) { *value = 1; }
int getUniformLocation(unsigned int, const char*) { return locations++; }
void uniform1f(int, float) { ++calls; }
void uniform1i(int, int) { ++calls; }
void uniform3fv(int, int, const float*) { ++calls; }

template <class Function>
void (*untyped(Function* function))()
{
    return reinterpret_cast<void (*)()>(function);
}

void (*find(const char* text))()
{
    const std::string_view name = text;
    if (name == "glIsProgram") return untyped(isProgram);
    if (name == "glGetProgramiv") return untyped(getProgramiv);
    if (name == "glGetUniformLocation") return untyped(getUniformLocation);
    if (name == "glUniform1f") return untyped(uniform1f);
    if (name == "glUniform1i") return untyped(uniform1i);
    if (name == "glUniform3fv") return untyped(uniform3fv);
    return nullptr;
}

}  // namespace

GetProcAddress nullGl()
{
    return find;
}

long nullGlCalls()
{
    return calls;
}

}  // namespace nacre::test
