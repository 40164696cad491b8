#pragma once

#include <cstddef>
#include <vector>

namespace nacre::bench {

/// Median and quartiles.
struct Summary {
    std::size_t count = 0;
    double median = 0.0, lowerQuartile = 0.0, upperQuartile = 0.0;
};

Summary summarize(std::vector<double> values);

}  // namespace nacre::bench
