#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <nacre/block.hpp>
#include <nacre/result.hpp>

namespace nacre {

/// How the host looks up OpenGL functions: eglGetProcAddress, OSMesaGetProcAddress and
/// glfwGetProcAddress fit as they are.
using GetProcAddress = void (*(*)(const char* name))();

/// A member of Block and the uniform that carries it.
struct BlockMember {
    enum class Type { vec3, real, integer };
    const char* uniform;  ///< `nacre_u_eta`
    Type type;
    std::size_t offset;  ///< In Block, bytes; std140 puts it at the same place.
};

/// All members of Block.
const std::array<BlockMember, 34>& blockMembers() noexcept;

/// Sets a material by plain uniforms (GlslUniforms::plain).
///
///     auto uniforms = nacre::Uniforms::locate(glfwGetProcAddress, program);
///     glUseProgram(program);
///     uniforms->set(*nacre::pack(material));
class Uniforms {
public:
    /// Looks up the locations in a linked program, once; the context must be current. A uniform that the
    /// compiler removed is no error. Errors: a function that the host cannot find, a program that is
    /// none or is not linked, a program without any uniform of nacre's.
    static Result<Uniforms> locate(GetProcAddress getProcAddress, unsigned int program);

    /// Sets them for the program, which must be in use. No look-up, no allocation.
    void set(const Block& block) const noexcept;

private:
#if defined(_WIN32) && !defined(_WIN64)
#define NACRE_GL_CALL __stdcall
#else
#define NACRE_GL_CALL
#endif
    void(NACRE_GL_CALL* uniform1f_)(int, float) = nullptr;
    void(NACRE_GL_CALL* uniform1i_)(int, int) = nullptr;
    void(NACRE_GL_CALL* uniform3fv_)(int, int, const float*) = nullptr;
    std::array<int, 34> locations_{};
};

}  // namespace nacre
