#include "progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

namespace nacre::bench {

ProgressBar::ProgressBar(std::string what) : what_(std::move(what)), isTerminal_(isatty(STDERR_FILENO) == 1)
{
    show(0.0);
}

ProgressBar::~ProgressBar()
{
    if (isTerminal_) std::cerr << "\r\033[K" << std::flush;
}

void ProgressBar::show(double share)
{
    if (!isTerminal_) return;
    constexpr int cells = 40;
    const int full = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * cells));
    std::cerr << "\r\033[K" << what_ << " [" << std::string(static_cast<std::size_t>(full), '#')
              << std::string(static_cast<std::size_t>(cells - full), '.') << ']' << std::flush;
}

}  // namespace nacre::bench
