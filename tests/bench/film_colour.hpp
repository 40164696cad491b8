#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "candidate.hpp"
#include "gl/context.hpp"

namespace nacre::bench {

/// A candidate's bench_film as a program: the colours that its GLSL gives to films.
class FilmProgram {
public:
    static Result<FilmProgram> create(const demo::GlFunctions& gl, const Candidate& candidate);
    ~FilmProgram();
    FilmProgram(FilmProgram&& other) noexcept;
    FilmProgram(const FilmProgram&) = delete;
    FilmProgram& operator=(const FilmProgram&) = delete;

    /// Linear Rec.709, in the order of the films. Films that follow one another and differ in thickness and angle
    /// alone are drawn together. An error where a block cannot be had or the driver reports one.
    Result<std::vector<glm::dvec3>> colours(const std::vector<test::FilmCase>& films) const;

private:
    FilmProgram(const demo::GlFunctions& gl, const Candidate& candidate) : gl_(&gl), candidate_(&candidate) {}
    const demo::GlFunctions* gl_;
    const Candidate* candidate_;
    GLuint program_ = 0, vertexArray_ = 0;
    std::vector<std::pair<GLenum, GLuint>> tables_;  // target and name
};

}  // namespace nacre::bench
