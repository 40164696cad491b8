#pragma once

#include <cstdint>
#include <string>

namespace nacre::bench {

enum class Architecture {
    gcn,   ///< 64 lanes over a SIMD of 16: four cycles per instruction, sixteen for a transcendental one.
    rdna,  ///< 64 lanes over a SIMD of 32: two cycles; transcendentals on a unit of a quarter's width beside it.
};

/// Cycles that the vector instructions of a shader keep a SIMD busy for 64 lanes, every branch taken.
/// The driver's own inverse throughput counts what stands behind a branch as taken 3 times in 4, or every
/// second time where the branch is the same for all lanes. For shaders that guard most of their work by
/// tests that nearly always pass that is too little, and less for one shader than for another.
/// 0 where the text, RADV's `Assembly`, has no vector instruction.
std::uint64_t vectorCycles(const std::string& assembly, Architecture architecture);

}  // namespace nacre::bench
