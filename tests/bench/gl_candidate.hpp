#pragma once

#include <string>
#include <vector>

#include "candidate.hpp"
#include "gl/context.hpp"

namespace nacre::bench {

/// Makes llvmpipe draw in the thread that calls it. It reads this when the process first makes a context.
void drawInCallingThread();

/// The texture of a table, which holds `texels` and is bound to the active unit. The caller deletes it.
GLuint makeTexture(const demo::GlFunctions& gl, const Table& table, const std::vector<float>& texels);

/// A candidate in OpenGL: its programs, its block in a uniform buffer, its tables in textures.
class GlCandidate {
public:
    /// Compiles the candidate without a loop, for one light, and with one.
    static Result<GlCandidate> create(const demo::GlFunctions& gl, const Candidate& candidate);

    void destroy(const demo::GlFunctions& gl) const;

    enum class Inputs {
        bound,
        zeroBlock,   ///< The block's bytes are all 0.
        zeroTables,  ///< The tables' texels are all 0.
    };

    /// Makes everything current for a draw: program, block, tables.
    void use(const demo::GlFunctions& gl, bool oneLight, Inputs inputs = Inputs::bound) const;

    /// The uniform block of frame.glsl is read from this binding,
    static constexpr GLuint frameBinding = 0;
    /// and the candidate's own from this one.
    static constexpr GLuint blockBinding = 1;

private:
    struct Texture {
        GLenum target;
        GLuint name, zero;
    };
    GLuint straight_ = 0, loop_ = 0;
    GLuint block_ = 0, zeroBlock_ = 0;
    std::vector<Texture> textures_;
};

}  // namespace nacre::bench
