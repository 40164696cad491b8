#include "film_colour.hpp"

#include <algorithm>

#include "gl/program.hpp"
#include "gl_candidate.hpp"
#include "shader_text.hpp"

namespace nacre::bench {
namespace {

constexpr std::size_t side = 512;     // films per row of the picture
constexpr std::size_t texels = 3;     // of film.glsl per film
constexpr std::size_t most = side * side;  // films of one picture

// What film.glsl fetches, rows of `side` films, the last one filled up with zeros.
std::vector<float> filmTexels(const test::FilmCase* films, std::size_t count)
{
    const std::size_t rows = (count + side - 1) / side;
    std::vector<float> values(rows * side * texels * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const test::FilmCase& film = films[i];
        const double data[texels][4] = {
            {film.index, film.thicknessNm / 1000.0, film.cosTheta, 0.0},
            {film.substrate[0].real(), film.substrate[1].real(), film.substrate[2].real(), 0.0},
            {film.substrate[0].imag(), film.substrate[1].imag(), film.substrate[2].imag(), 0.0},
        };
        for (std::size_t k = 0; k < texels * 4; ++k) values[i * texels * 4 + k] = static_cast<float>(data[k / 4][k % 4]);
    }
    return values;
}

bool haveOneMaterial(const test::FilmCase& a, const test::FilmCase& b)
{
    return a.index == b.index && std::equal(a.substrate, a.substrate + 3, b.substrate);
}

// Texture, picture and buffer of one call, given back with it.
struct Objects {
    explicit Objects(const demo::GlFunctions& functions) : gl(functions)
    {
        gl.GenTextures(1, &films);
        gl.GenTextures(1, &picture);
        gl.GenFramebuffers(1, &framebuffer);
        gl.GenBuffers(1, &block);
    }
    ~Objects()
    {
        gl.DeleteFramebuffers(1, &framebuffer);
        gl.DeleteTextures(1, &films);
        gl.DeleteTextures(1, &picture);
        gl.DeleteBuffers(1, &block);
    }
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;

    // A float texture that is fetched from, or drawn to.
    void fill(GLuint texture, std::size_t width, std::size_t height, const float* values) const
    {
        gl.BindTexture(GL_TEXTURE_2D, texture);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(width), static_cast<GLsizei>(height), 0, GL_RGBA, GL_FLOAT, values);
    }

    const demo::GlFunctions& gl;
    GLuint films = 0, picture = 0, framebuffer = 0, block = 0;
};

}  // namespace

Result<FilmProgram> FilmProgram::create(const demo::GlFunctions& gl, const Candidate& candidate)
{
    FilmProgram made(gl, candidate);
    Result<std::string> fragment = filmShader(candidate);
    if (!fragment) return fragment.error();
    Result<GLuint> program = demo::linkProgram(gl, vertexShader(Dialect::openGl), *fragment);
    if (!program) return program.error();
    made.program_ = *program;
    gl.GenVertexArrays(1, &made.vertexArray_);

    gl.UseProgram(made.program_);
    const auto setUnit = [&](const char* sampler, std::size_t unit) {
        const GLint location = gl.GetUniformLocation(made.program_, sampler);
        if (location >= 0) gl.Uniform1i(location, static_cast<GLint>(unit));
        return location >= 0;
    };
    if (!setUnit("bench_films", candidate.tables.size())) return Error{"bench_film does not read its film"};
    for (std::size_t unit = 0; unit < candidate.tables.size(); ++unit) {
        const Table& table = candidate.tables[unit];
        setUnit(table.sampler.c_str(), unit);  // a table may serve the lighting alone
        made.tables_.emplace_back(table.height > 0 ? GL_TEXTURE_2D : GL_TEXTURE_1D, makeTexture(gl, table, table.texels));
    }
    if (candidate.film.block) {
        const GLuint index = gl.GetUniformBlockIndex(made.program_, candidate.blockName.c_str());
        if (index == GL_INVALID_INDEX) return Error{"bench_film does not read its block " + candidate.blockName};
        gl.UniformBlockBinding(made.program_, index, GlCandidate::blockBinding);
    }
    return made;
}

FilmProgram::FilmProgram(FilmProgram&& other) noexcept
    : gl_(other.gl_), candidate_(other.candidate_), program_(other.program_), vertexArray_(other.vertexArray_), tables_(std::move(other.tables_))
{
    other.program_ = other.vertexArray_ = 0;
    other.tables_.clear();
}

FilmProgram::~FilmProgram()
{
    gl_->DeleteProgram(program_);
    gl_->DeleteVertexArrays(1, &vertexArray_);
    for (const auto& table : tables_) gl_->DeleteTextures(1, &table.second);
}

Result<std::vector<glm::dvec3>> FilmProgram::colours(const std::vector<test::FilmCase>& films) const
{
    const demo::GlFunctions& gl = *gl_;
    const Objects objects(gl);
    std::vector<glm::dvec3> colours;
    colours.reserve(films.size());
    for (std::size_t first = 0; first < films.size(); first += most) {
        const std::size_t count = std::min(most, films.size() - first), rows = (count + side - 1) / side;
        const test::FilmCase* const part = films.data() + first;

        gl.ActiveTexture(GL_TEXTURE0);
        objects.fill(objects.picture, side, rows, nullptr);
        gl.BindTexture(GL_TEXTURE_2D, 0);
        gl.BindFramebuffer(GL_FRAMEBUFFER, objects.framebuffer);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, objects.picture, 0);
        if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return Error{"the driver cannot render to a floating-point picture"};

        gl.UseProgram(program_);
        gl.BindVertexArray(vertexArray_);
        for (std::size_t unit = 0; unit < tables_.size(); ++unit) {
            gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            gl.BindTexture(tables_[unit].first, tables_[unit].second);
        }
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(tables_.size()));
        objects.fill(objects.films, side * texels, rows, filmTexels(part, count).data());

        // Runs of films within a row that share a block; without a block whole rows.
        const FilmHook& hook = candidate_->film;
        for (std::size_t at = 0, end = 0; at < count; at = end) {
            const std::size_t rowEnd = std::min(count, (at / side + 1) * side);
            end = at + 1;
            while (end < rowEnd && (!hook.block || haveOneMaterial(part[at], part[end]))) ++end;
            if (hook.block && (at == 0 || !haveOneMaterial(part[at - 1], part[at]))) {
                Result<std::vector<unsigned char>> block = hook.block(part[at]);
                if (!block) return block.error();
                block->resize((block->size() + 15) / 16 * 16);  // as std140 rounds the size of a block
                gl.BindBuffer(GL_UNIFORM_BUFFER, objects.block);
                gl.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(block->size()), block->data(), GL_STATIC_DRAW);
                gl.BindBufferBase(GL_UNIFORM_BUFFER, GlCandidate::blockBinding, objects.block);
            }
            gl.Viewport(static_cast<GLint>(at % side), static_cast<GLint>(at / side), static_cast<GLsizei>(end - at), 1);
            gl.DrawArrays(GL_TRIANGLES, 0, 3);
        }

        std::vector<float> pixels(rows * side * 3);
        gl.ReadPixels(0, 0, static_cast<GLsizei>(side), static_cast<GLsizei>(rows), GL_RGB, GL_FLOAT, pixels.data());
        for (std::size_t i = 0; i < count; ++i) colours.emplace_back(pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]);
    }
    if (const GLenum error = gl.GetError()) return Error{"OpenGL error " + std::to_string(error) + " while films were drawn"};
    return colours;
}

}  // namespace nacre::bench
