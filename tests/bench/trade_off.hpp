#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report.hpp"

namespace nacre::bench {

/// By candidate; nothing where it was not measured.
using Measured = std::vector<std::optional<double>>;

/// What the candidates cost on one device.
struct DeviceCost {
    std::string device;  ///< `llvmpipe` or RADV's name of a family.
    std::string title;   ///< Device and setting, for people.
    std::string unit;    ///< `three.js = 1`, or what is counted over flat where three.js is missing.
    Measured cost;       ///< Over flat; one light, or the fewest that were timed, and the first size.
};

/// llvmpipe first, then the families in their order; those without a measurement are left out. Of a
/// family vector cycles, or where they are not known the driver's inverse throughput.
std::vector<DeviceCost> deviceCosts(const Report& report);

/// Mean CIEDE2000 of each candidate over one of test::filmSets().
Measured meanErrors(const Report& report, std::size_t set);

/// The Pareto front: no other candidate is as fast and as close, and one of both better. Errors within 1 % of each
/// other are the same: forms of one model differ by the rounding of their arithmetic.
std::vector<bool> onFront(const Measured& cost, const Measured& error);

/// One of those that show what a single stable form costs: nothing to choose in earnest.
bool isNaiveForm(const Candidate& candidate);

/// Speed beside error for every candidate that models a film: a Markdown table.
std::string tradeOffTable(const Report& report);

/// Every error figure, bands included, one line each; the front by device in the lines of whole sets.
std::string filmCsv(const Report& report);

/// ns per pixel and light by the number of lights, and by the size of the picture: Markdown tables, for
/// what was timed with more than one of them.
std::string scalingTables(const Report& report);

}  // namespace nacre::bench
