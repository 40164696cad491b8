#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "candidate.hpp"

namespace nacre::bench {

/// What Mesa's RADV reports of a fragment shader that it compiled: VK_KHR_pipeline_executable_properties.
struct RadvStatistics {
    std::uint64_t instructions = 0, vgprs = 0, sgprs = 0, codeSize = 0;
    std::uint64_t latency = 0;            ///< Cycles of one wave.
    std::uint64_t inverseThroughput = 0;  ///< Cycles that 64 lanes keep the busiest unit from others; branches weighted.
    std::uint64_t vectorCycles = 0;       ///< The same of vector instructions, all branches taken; 0: not known.
};

struct RadvShader {
    std::size_t candidate = 0;
    RadvStatistics oneLight, twoLights;  ///< The difference is what a further light costs.
};

struct RadvReport {
    std::string family;  ///< `navi21`
    std::string device;  ///< As the driver names it.
    std::vector<RadvShader> shaders;
    std::string failure;  ///< Why there are no shaders; else empty.
};

struct RadvReports {
    std::vector<RadvReport> families;
    std::vector<Failure> failures;
};

/// Compiles the candidates into pipelines for graphics processors of AMD's families, none of which needs
/// to be there: RADV_FORCE_FAMILY gives RADV a device without hardware. Each family has a process of its
/// own, forked before this one starts threads, since the driver reads that variable once.
/// Lights are unrolled: the compiler counts any loop as eight rounds.
///   folder  for intermediate files
/// An error where nothing can be compiled: no glslangValidator.
Result<RadvReports> measureRadv(const std::vector<Candidate>& candidates, const std::vector<std::string>& families,
                                const std::filesystem::path& folder);

}  // namespace nacre::bench
