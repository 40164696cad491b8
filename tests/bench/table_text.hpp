#pragma once

#include <string>
#include <vector>

namespace nacre::bench {

std::string fixed(double value, int digits);
/// A figure of which two or three digits say enough: 0.044, 0.36, 4.9, 23.
std::string shortly(double value);

/// A row of a Markdown table.
std::string row(const std::vector<std::string>& cells);
/// Its header, the first column to the left and all others to the right.
std::string header(const std::vector<std::string>& cells);

std::string csvLine(const std::vector<std::string>& cells);
/// A name without commas.
std::string csvName(std::string text);

}  // namespace nacre::bench
