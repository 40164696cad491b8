#include "picture.hpp"

namespace nacre::test {

GLuint bindBlock(const demo::GlFunctions& gl, GLuint program, const char* block, GLuint binding, const void* bytes, std::size_t count)
{
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_UNIFORM_BUFFER, buffer);
    gl.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(count), bytes, GL_STATIC_DRAW);
    gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, block), binding);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
    return buffer;
}

std::vector<std::vector<glm::vec4>> drawPicture(const demo::GlFunctions& gl, GLuint program, int width, int height, int targets)
{
    GLuint framebuffer = 0, vertexArray = 0;
    std::vector<GLuint> textures(static_cast<std::size_t>(targets));
    std::vector<GLenum> attachments;
    gl.GenFramebuffers(1, &framebuffer);
    gl.GenVertexArrays(1, &vertexArray);
    gl.GenTextures(targets, textures.data());
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    for (GLuint texture : textures) {
        gl.BindTexture(GL_TEXTURE_2D, texture);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
        attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, texture, 0);
    }
    gl.DrawBuffers(targets, attachments.data());
    gl.Viewport(0, 0, width, height);
    gl.BindVertexArray(vertexArray);
    gl.UseProgram(program);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<std::vector<glm::vec4>> pictures;
    for (GLenum attachment : attachments) {
        pictures.emplace_back(static_cast<std::size_t>(width * height));
        gl.ReadBuffer(attachment);
        gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pictures.back().data());
    }
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.DeleteTextures(targets, textures.data());
    gl.DeleteVertexArrays(1, &vertexArray);
    return pictures;
}

}  // namespace nacre::test
