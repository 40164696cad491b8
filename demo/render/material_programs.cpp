#include "material_programs.hpp"

#include <string>
#include <utility>

#include "gl/program.hpp"
#include "shaders.hpp"

namespace nacre::demo {
namespace {

Result<GLuint> linkFor(const GlFunctions& gl, const std::vector<GlslFile>& files, const Features& features)
{
    GlslOptions options;
    options.features = features;
    options.files = &files;
    Result<std::string> library = glsl(options);
    if (!library) return library.error();
    Result<GLuint> program = linkProgram(gl, meshVertexShader, *library + meshFragmentShader);
    if (program) gl.UniformBlockBinding(*program, gl.GetUniformBlockIndex(*program, "nacre_Block"), 0);
    return program;
}

}  // namespace

Result<MaterialPrograms> MaterialPrograms::create(const GlFunctions& gl, std::vector<GlslFile> files)
{
    // The library's own files are known to compile; others show their faults here, in the shader of everything.
    const bool isLibrary = files.size() == glslFiles().size() && files.front().text.data() == glslFiles().front().text.data();
    if (!isLibrary) {
        Result<GLuint> whole = linkFor(gl, files, Features{});
        if (!whole) return whole.error();
        gl.DeleteProgram(*whole);
    }
    return MaterialPrograms(gl, std::move(files));
}

Result<GLuint> MaterialPrograms::of(const Material& material)
{
    FeatureOptions options;
    options.machine = Machine::cpu;  // the demo is made for machines without a GPU
    Result<Features> features = featuresOf(material, options);
    if (!features) return features.error();
    const auto found = programs_.find(key(*features));
    if (found != programs_.end()) return found->second;
    Result<GLuint> program = linkFor(*gl_, files_, *features);
    if (program) programs_.emplace(key(*features), *program);
    return program;
}

MaterialPrograms::MaterialPrograms(MaterialPrograms&& other) noexcept
    : gl_(other.gl_), files_(std::move(other.files_)), programs_(std::exchange(other.programs_, {}))
{
}

MaterialPrograms& MaterialPrograms::operator=(MaterialPrograms&& other) noexcept
{
    std::swap(gl_, other.gl_);
    std::swap(files_, other.files_);
    std::swap(programs_, other.programs_);
    return *this;
}

MaterialPrograms::~MaterialPrograms()
{
    for (const auto& [number, program] : programs_) gl_->DeleteProgram(program);
}

}  // namespace nacre::demo
