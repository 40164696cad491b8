#pragma once

#include <string>

namespace nacre::bench {

/// A bar on standard error where that is a terminal, else nothing.
class ProgressBar {
public:
    explicit ProgressBar(std::string what);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    void show(double share);  ///< 0 to 1

private:
    std::string what_;
    bool isTerminal_;
};

}  // namespace nacre::bench
