#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <nacre/block.hpp>

#include "inputs.hpp"

namespace nacre::test {

/// A batch of adversarial evaluations: some materials, many points of each.
struct SoakBatch {
    std::vector<model::Material> materials;
    std::vector<Block> blocks;
    std::vector<Input> inputs;
    std::vector<GpuPoint> points;
    std::vector<glm::vec4> rho, diffuse;  ///< What the GPU makes of them.

    /// The same for the same seed and index, whatever runs beside it.
    static SoakBatch make(std::uint64_t seed, std::uint64_t index, std::size_t count);
};

/// What the soak counts, channels and both coefficients each for itself.
struct SoakTally {
    std::uint64_t nan = 0, infinite = 0, negative = 0;
    std::uint64_t overBound = 0;
    std::uint64_t undirected = 0;  ///< Not 0 where a normal has no direction.
    std::uint64_t atJump = 0;      ///< Over the bound, with inputs on both sides of a jump of the model.
    std::uint64_t moved = 0;       ///< Over the bound at first, so that the inputs were moved.
    double worst = 0.0;            ///< Largest error that counts, in units of the bound; near 1 once inputs had to be moved.
    /// How many channels of ρ come within 1e-6, 1e-5 and 1e-4 of the double-precision model as they are, per
    /// max(1, ρ, d / 10 µm), and how many there are.
    std::array<std::uint64_t, 3> within{};
    std::uint64_t channels = 0;
    Input worstInput{};
    std::vector<Input> failures;  ///< Those that do not pass, a thousand at most.

    bool passes() const { return nan + infinite + negative + overBound + undirected == 0; }
    SoakTally& operator+=(const SoakTally& other);
};

/// Compares the GPU's results with the double-precision model.
/// The bound is 3e-4 max(1, ρ, d / 10 µm): cosines of 1e-6 in a random frame are 6e-8 / 1e-6 uncertain and a
/// transmittance takes their root; beyond 10 µm the phase's rounding grows with the thickness.
/// The error is the distance to what the model gives for inputs within 4 ulp.
SoakTally judge(const SoakBatch& batch);

}  // namespace nacre::test
