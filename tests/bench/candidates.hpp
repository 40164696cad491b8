#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "candidate.hpp"

namespace nacre::bench {

/// Increments and ratios are taken over the first and to the second.
inline constexpr std::string_view flatName = "flat";
inline constexpr std::string_view referenceName = "three.js";

/// A candidate before it is loaded; loading one of the peers may fetch a package.
struct CandidateEntry {
    std::string name;
    std::string shows;
    std::function<Result<Candidate>(const std::filesystem::path& peers)> load;
};

/// All there are; see candidates.cpp for how to add one.
const std::vector<CandidateEntry>& candidateEntries();

}  // namespace nacre::bench
