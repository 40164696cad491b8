#pragma once

namespace nacre::demo {

/// A slider with two handles, from least to most; a drag moves the handle that is nearer, or both where it begins
/// between them with Shift. True where the values changed.
bool rangeSlider(const char* id, double& lower, double& upper, double least, double most);

}  // namespace nacre::demo
