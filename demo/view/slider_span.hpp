#pragma once

#include <nacre/parameters.hpp>

namespace nacre::demo {

/// The part of a parameter's range that a slider shows: where most materials are. Any value of the range can be
/// typed (Ctrl and a click).
struct SliderSpan {
    double least, most;
    bool isLogarithmic;
};
SliderSpan sliderSpan(const Parameter& parameter);

}  // namespace nacre::demo
