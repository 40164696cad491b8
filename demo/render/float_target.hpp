#pragma once

#include "gl/functions.hpp"

namespace nacre::demo {

/// A framebuffer of one float colour and one depth buffer, freed with it; bound when made.
class FloatTarget {
public:
    FloatTarget(const GlFunctions& gl, int width, int height);
    ~FloatTarget();
    FloatTarget(const FloatTarget&) = delete;
    FloatTarget& operator=(const FloatTarget&) = delete;

    /// Binds it and sets the viewport to all of it.
    void use() const;
    bool isComplete() const;
    GLuint framebuffer() const { return framebuffer_; }
    GLuint colour() const { return colour_; }
    int width() const { return width_; }
    int height() const { return height_; }

private:
    const GlFunctions& gl_;
    int width_, height_;
    GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
};

}  // namespace nacre::demo
