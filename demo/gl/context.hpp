#pragma once

#include <memory>
#include <string>

#include <nacre/result.hpp>
#include <nacre/uniforms.hpp>

#include "functions.hpp"

namespace nacre::demo {

/// Where an OpenGL context without a window comes from.
enum class ContextKind {
    any,     ///< What NACRE_CONTEXT=osmesa|egl asks for, else OSMesa, else EGL.
    osmesa,  ///< Mesa up to 25.0, off screen, software only.
    egl,     ///< Surfaceless EGL: OSMesa's successor; uses a GPU where there is one.
};

/// A current OpenGL 3.3 core context that draws to framebuffer objects only. The one place in the
/// project that creates one without a window. Both libraries are opened at run time, so that one binary
/// runs where either is missing.
class Context {
public:
    static Result<Context> create(ContextKind kind = ContextKind::any);

    const GlFunctions& gl() const { return gl_; }
    GetProcAddress getProcAddress() const { return getProcAddress_; }
    /// `OSMesa`, `EGL`
    const std::string& kind() const { return kind_; }
    /// The driver's own name: `llvmpipe (LLVM 15.0.6, 256 bits)`
    std::string renderer() const;

private:
    Context() = default;
    std::shared_ptr<void> handle_;  // destroys the context
    GetProcAddress getProcAddress_ = nullptr;
    GlFunctions gl_;
    std::string kind_;

    static Result<Context> createOsmesa();
    static Result<Context> createEgl();
    Result<Context> withFunctions() &&;
};

}  // namespace nacre::demo
