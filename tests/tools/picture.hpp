#pragma once

#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "gl/functions.hpp"

namespace nacre::test {

/// A vertex shader without inputs: one triangle that covers the picture.
inline constexpr const char* pictureVertexShader = R"(#version 330 core
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
)";

/// A uniform buffer with these bytes, at a binding point, which the program's block of that name reads from. The caller
/// deletes it.
GLuint bindBlock(const demo::GlFunctions& gl, GLuint program, const char* block, GLuint binding, const void* bytes, std::size_t count);

/// What the program gives for every pixel of a picture, per target from location 0 on, rows from the bottom up.
std::vector<std::vector<glm::vec4>> drawPicture(const demo::GlFunctions& gl, GLuint program, int width, int height, int targets);

}  // namespace nacre::test
