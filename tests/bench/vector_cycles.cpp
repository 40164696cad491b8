#include "vector_cycles.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace nacre::bench {
namespace {

bool isTranscendental(std::string_view instruction)
{
    for (const std::string_view name : {"v_rcp_", "v_rsq_", "v_sqrt_", "v_sin_", "v_cos_", "v_exp_", "v_log_"}) {
        if (instruction.substr(0, name.size()) == name) return true;
    }
    return false;
}

}  // namespace

std::uint64_t vectorCycles(const std::string& assembly, Architecture architecture)
{
    std::uint64_t all = 0, transcendental = 0;
    std::istringstream lines(assembly);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find_first_not_of(" \t");
        if (start == std::string::npos || line.compare(start, 2, "v_") != 0) continue;
        ++all;
        if (isTranscendental(std::string_view(line).substr(start))) ++transcendental;
    }
    if (architecture == Architecture::gcn) return 4 * (all - transcendental) + 16 * transcendental;
    return std::max(2 * all, 8 * transcendental);
}

}  // namespace nacre::bench
