#pragma once

#include <string>
#include <vector>

namespace nacre::demo {

/// The number that is all of the text, in C's notation whatever the locale; false where it is none.
bool parseNumber(const std::string& text, double& value);

/// `1.4,1.45`: as parseNumber() reads it, short; 9 digits, which give every float back.
std::string numberText(double value);

/// The parts of `a,b,c`; one where the separator is absent.
std::vector<std::string> split(const std::string& text, const std::string& separator);

}  // namespace nacre::demo
