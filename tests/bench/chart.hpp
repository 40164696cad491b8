#pragma once

#include <filesystem>

#include "report.hpp"

namespace nacre::bench {

/// Whether `plot` can work: gnuplot is there, and a PNG can be written under this name. Asked before the
/// measurements, so that none are made in vain.
Outcome checkPlot(const std::filesystem::path& file);

/// Speed against error for every candidate that models a film, over dielectrics up to 800 nm: a PNG with a
/// panel for llvmpipe and one for the first of RADV's families. The file appears whole or not at all.
Outcome plot(const Report& report, const std::filesystem::path& file);

}  // namespace nacre::bench
