#include "statistics.hpp"

#include <algorithm>
#include <cmath>

namespace nacre::bench {
namespace {

// Linear between the two values that a share of the sorted ones falls between.
double quantile(const std::vector<double>& sorted, double share)
{
    const double at = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - std::floor(at)) * (sorted[above] - sorted[below]);
}

}  // namespace

Summary summarize(std::vector<double> values)
{
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {values.size(), quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

}  // namespace nacre::bench
