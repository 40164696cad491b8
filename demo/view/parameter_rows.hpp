#pragma once

#include "log.hpp"
#include "state.hpp"

namespace nacre::demo {

/// A row of the current window for each of nacre::parameters(): name and symbol, control, reset, and a tooltip with what it
/// does. Values that do not validate cannot be set. True where the look changed.
bool parameterRows(Look& look, bool isPhysicalSeen, Log& log);

}  // namespace nacre::demo
