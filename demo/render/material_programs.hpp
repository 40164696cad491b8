#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <nacre/features.hpp>
#include <nacre/glsl.hpp>
#include <nacre/material.hpp>
#include <nacre/result.hpp>

#include "gl/functions.hpp"

namespace nacre::demo {

/// The demo's shader programs with the library in them: one for each set of features that was asked for, linked when it
/// first is; freed with it.
class MaterialPrograms {
public:
    /// files: the library's, or others of the same names in the same order. An error where they do not compile, in
    /// whatever part of them.
    static Result<MaterialPrograms> create(const GlFunctions& gl, std::vector<GlslFile> files = glslFiles());
    ~MaterialPrograms();
    MaterialPrograms(MaterialPrograms&& other) noexcept;
    MaterialPrograms& operator=(MaterialPrograms&& other) noexcept;

    /// The program that shades the material and computes no more than it needs.
    Result<GLuint> of(const Material& material);

private:
    MaterialPrograms(const GlFunctions& gl, std::vector<GlslFile> files) : gl_(&gl), files_(std::move(files)) {}

    const GlFunctions* gl_;
    std::vector<GlslFile> files_;
    std::map<std::uint64_t, GLuint> programs_;  // by nacre::key
};

}  // namespace nacre::demo
