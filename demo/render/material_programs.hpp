#pragma once

#include <array>
#include <vector>

#include <nacre/glsl.hpp>
#include <nacre/material.hpp>
#include <nacre/result.hpp>

#include "gl/functions.hpp"

namespace nacre::demo {

/// The demo's shader programs with the library in them, one for each quality; freed with it.
class MaterialPrograms {
public:
    /// files: the library's, or others of the same names in the same order.
    static Result<MaterialPrograms> link(const GlFunctions& gl, const std::vector<GlslFile>& files = glslFiles());
    ~MaterialPrograms();
    MaterialPrograms(MaterialPrograms&& other) noexcept;
    MaterialPrograms& operator=(MaterialPrograms&& other) noexcept;

    GLuint of(const Material& material) const { return programs_[static_cast<std::size_t>(material.quality)]; }

private:
    explicit MaterialPrograms(const GlFunctions& gl) : gl_(&gl) {}

    const GlFunctions* gl_;
    std::array<GLuint, 2> programs_{};  // by Quality
};

}  // namespace nacre::demo
