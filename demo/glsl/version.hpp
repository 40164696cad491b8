#pragma once

#include <string>

#include <nacre/glsl.hpp>
#include <nacre/result.hpp>

namespace nacre::demo {

/// Sets version, es and vulkan from `330`, `330 core`, `300 es` or `450 vulkan`.
Outcome setVersion(GlslOptions& options, const std::string& text);

/// The same text.
std::string versionText(const GlslOptions& options);

}  // namespace nacre::demo
