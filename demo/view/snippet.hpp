#pragma once

#include <string>

#include "state.hpp"

namespace nacre::demo {

/// The look as C++ that makes it: a preset or the default, then what differs.
std::string snippet(const Look& look);

/// The nacre-render command that draws a material from this viewpoint into the state's file, in its size.
std::string renderCommand(const State& state);

}  // namespace nacre::demo
