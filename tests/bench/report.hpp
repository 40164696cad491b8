#pragma once

#include <optional>
#include <string>
#include <vector>

#include "film_report.hpp"
#include "llvmpipe.hpp"
#include "radv.hpp"

namespace nacre::bench {

/// All that a run found out.
struct Report {
    std::vector<Candidate> candidates;  ///< The first is flat.
    std::size_t reference = 0;          ///< Index of three.js; beyond the last where it is missing.
    std::optional<LlvmpipeReport> llvmpipe;
    std::vector<RadvReport> radv;
    std::optional<FilmReport> films;
    std::vector<std::string> notes;  ///< What could not be had, a line each.
};

/// Tables for people.
std::string markdown(const Report& report);

/// One line per candidate and setting or family; cells that mean nothing there are empty.
std::string csv(const Report& report);

}  // namespace nacre::bench
