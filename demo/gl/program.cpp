#include "program.hpp"

#include <cstddef>
#include <sstream>
#include <vector>

#include <nacre/glsl.hpp>

namespace nacre::demo {
namespace {

// "3:17(5): error" becomes "nacre_direction.glsl:17(5): error".
std::string withFileNames(const std::string& log)
{
    std::istringstream lines(log);
    std::string named;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(':');
        const bool isNumber = colon != std::string::npos && colon > 0 && colon < 3 &&
                              line.find_first_not_of("0123456789") == colon;
        const std::size_t source = isNumber ? std::stoul(line) : 0;
        if (source > 0 && source <= glslFiles().size()) line.replace(0, colon, glslFiles()[source - 1].name);
        named += line + '\n';
    }
    return named;
}

Result<GLuint> compile(const GlFunctions& gl, GLenum stage, const std::string& source)
{
    const GLuint shader = gl.CreateShader(stage);
    const char* text = source.c_str();
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    GLint compiled = 0, length = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> log(static_cast<std::size_t>(length) + 1);
    gl.GetShaderInfoLog(shader, length, nullptr, log.data());
    gl.DeleteShader(shader);
    return Error{"GLSL does not compile: " + withFileNames(log.data())};
}

}  // namespace

Result<GLuint> linkProgram(const GlFunctions& gl, const std::string& vertexSource, const std::string& fragmentSource)
{
    Result<GLuint> vertex = compile(gl, GL_VERTEX_SHADER, vertexSource);
    if (!vertex) return vertex.error();
    Result<GLuint> fragment = compile(gl, GL_FRAGMENT_SHADER, fragmentSource);
    if (!fragment) {
        gl.DeleteShader(*vertex);
        return fragment.error();
    }
    const GLuint program = gl.CreateProgram();
    gl.AttachShader(program, *vertex);
    gl.AttachShader(program, *fragment);
    gl.LinkProgram(program);
    gl.DeleteShader(*vertex);
    gl.DeleteShader(*fragment);
    GLint linked = 0, length = 0;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return program;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> log(static_cast<std::size_t>(length) + 1);
    gl.GetProgramInfoLog(program, length, nullptr, log.data());
    gl.DeleteProgram(program);
    return Error{"GLSL does not link: " + withFileNames(log.data())};
}

}  // namespace nacre::demo
