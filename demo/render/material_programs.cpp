#include "material_programs.hpp"

#include <string>
#include <utility>

#include "gl/program.hpp"
#include "shaders.hpp"

namespace nacre::demo {
namespace {

Result<GLuint> linkFor(const GlFunctions& gl, const std::vector<GlslFile>& files, Quality quality)
{
    GlslOptions options;
    options.files = &files;
    Result<std::string> library = glsl(options);
    if (!library) return library.error();
    const std::string define = "#define QUALITY_PHYSICAL " + std::to_string(quality == Quality::physical ? 1 : 0) + '\n';
    Result<GLuint> program = linkProgram(gl, meshVertexShader, *library + define + meshFragmentShader);
    if (program) gl.UniformBlockBinding(*program, gl.GetUniformBlockIndex(*program, "nacre_Block"), 0);
    return program;
}

}  // namespace

Result<MaterialPrograms> MaterialPrograms::link(const GlFunctions& gl, const std::vector<GlslFile>& files)
{
    MaterialPrograms linked(gl);
    for (const Quality quality : {Quality::paper, Quality::physical}) {
        Result<GLuint> program = linkFor(gl, files, quality);
        if (!program) return program.error();
        linked.programs_[static_cast<std::size_t>(quality)] = *program;
    }
    return linked;
}

MaterialPrograms::MaterialPrograms(MaterialPrograms&& other) noexcept
    : gl_(other.gl_), programs_(std::exchange(other.programs_, {}))
{
}

MaterialPrograms& MaterialPrograms::operator=(MaterialPrograms&& other) noexcept
{
    std::swap(gl_, other.gl_);
    std::swap(programs_, other.programs_);
    return *this;
}

MaterialPrograms::~MaterialPrograms()
{
    for (const GLuint program : programs_) {
        if (program) gl_->DeleteProgram(program);
    }
}

}  // namespace nacre::demo
