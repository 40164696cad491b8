#include "gl_candidate.hpp"

#include <cstdlib>

#include "gl/program.hpp"
#include "shader_text.hpp"

namespace nacre::bench {
namespace {

struct TexelFormat {
    GLint internal;
    GLenum external;
};

TexelFormat texelFormat(const Table& table)
{
    const auto pick = [&](GLint float32, GLint float16, GLint unorm8) {
        return table.format == Table::Format::float32 ? float32 : table.format == Table::Format::float16 ? float16 : unorm8;
    };
    if (table.channels == 1) return {pick(GL_R32F, GL_R16F, GL_R8), GL_RED};
    if (table.channels == 2) return {pick(GL_RG32F, GL_RG16F, GL_RG8), GL_RG};
    return {pick(GL_RGBA32F, GL_RGBA16F, GL_RGBA8), GL_RGBA};
}

GLuint makeBuffer(const demo::GlFunctions& gl, std::vector<unsigned char> bytes)
{
    bytes.resize((bytes.size() + 15) / 16 * 16);  // as std140 rounds the size of a block
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_UNIFORM_BUFFER, buffer);
    gl.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    return buffer;
}

Result<GLuint> makeProgram(const demo::GlFunctions& gl, const Candidate& candidate, int straightLights)
{
    Result<std::string> fragment = fragmentShader(candidate, Dialect::openGl, straightLights);
    if (!fragment) return fragment.error();
    Result<GLuint> program = demo::linkProgram(gl, vertexShader(Dialect::openGl), *fragment);
    if (!program) return program;
    gl.UseProgram(*program);
    const auto bind = [&](const std::string& block, GLuint binding) {
        const GLuint index = gl.GetUniformBlockIndex(*program, block.c_str());
        if (index == GL_INVALID_INDEX) return false;
        gl.UniformBlockBinding(*program, index, binding);
        return true;
    };
    if (!bind("bench_Frame", GlCandidate::frameBinding)) return Error{"the compiler removed bench_Frame"};
    if (!candidate.blockName.empty() && !bind(candidate.blockName, GlCandidate::blockBinding)) {
        return Error{"the shader does not read its block " + candidate.blockName};
    }
    for (std::size_t unit = 0; unit < candidate.tables.size(); ++unit) {
        const std::string& sampler = candidate.tables[unit].sampler;
        const GLint location = gl.GetUniformLocation(*program, sampler.c_str());
        if (location < 0) return Error{"the shader does not read its table " + sampler};
        gl.Uniform1i(location, static_cast<GLint>(unit));
    }
    return program;
}

}  // namespace

void drawInCallingThread()
{
    setenv("LP_NUM_THREADS", "0", 1);
}

GLuint makeTexture(const demo::GlFunctions& gl, const Table& table, const std::vector<float>& texels)
{
    const GLenum target = table.height > 0 ? GL_TEXTURE_2D : GL_TEXTURE_1D;
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(target, texture);
    const GLint filter = table.filter == Table::Filter::linear ? GL_LINEAR : GL_NEAREST;
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    const TexelFormat format = texelFormat(table);
    if (table.height > 0) {
        gl.TexImage2D(target, 0, format.internal, table.width, table.height, 0, format.external, GL_FLOAT, texels.data());
    } else {
        gl.TexImage1D(target, 0, format.internal, table.width, 0, format.external, GL_FLOAT, texels.data());
    }
    return texture;
}

Result<GlCandidate> GlCandidate::create(const demo::GlFunctions& gl, const Candidate& candidate)
{
    GlCandidate made;
    Result<GLuint> straight = makeProgram(gl, candidate, 1);
    if (!straight) return straight.error();
    Result<GLuint> loop = makeProgram(gl, candidate, 0);
    if (!loop) return loop.error();
    made.straight_ = *straight;
    made.loop_ = *loop;
    if (!candidate.blockName.empty()) {
        made.block_ = makeBuffer(gl, candidate.block);
        made.zeroBlock_ = makeBuffer(gl, std::vector<unsigned char>(candidate.block.size()));
    }
    for (const Table& table : candidate.tables) {
        const std::size_t expected =
            static_cast<std::size_t>(table.width) * static_cast<std::size_t>(table.height > 0 ? table.height : 1) *
            static_cast<std::size_t>(table.channels);
        if (table.texels.size() != expected) {
            return Error{"table " + table.sampler + ": expected " + std::to_string(expected) + " numbers, got " +
                         std::to_string(table.texels.size())};
        }
        const GLenum target = table.height > 0 ? GL_TEXTURE_2D : GL_TEXTURE_1D;
        made.textures_.push_back({target, makeTexture(gl, table, table.texels), makeTexture(gl, table, std::vector<float>(expected))});
    }
    return made;
}

void GlCandidate::destroy(const demo::GlFunctions& gl) const
{
    gl.DeleteProgram(straight_);
    gl.DeleteProgram(loop_);
    gl.DeleteBuffers(1, &block_);
    gl.DeleteBuffers(1, &zeroBlock_);
    for (const Texture& texture : textures_) {
        gl.DeleteTextures(1, &texture.name);
        gl.DeleteTextures(1, &texture.zero);
    }
}

void GlCandidate::use(const demo::GlFunctions& gl, bool oneLight, Inputs inputs) const
{
    gl.UseProgram(oneLight ? straight_ : loop_);
    if (block_) gl.BindBufferBase(GL_UNIFORM_BUFFER, blockBinding, inputs == Inputs::zeroBlock ? zeroBlock_ : block_);
    for (std::size_t unit = 0; unit < textures_.size(); ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl.BindTexture(textures_[unit].target, inputs == Inputs::zeroTables ? textures_[unit].zero : textures_[unit].name);
    }
}

}  // namespace nacre::bench
