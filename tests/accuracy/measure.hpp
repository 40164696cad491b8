#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "inputs.hpp"
#include "regions.hpp"
#include "shade.hpp"

namespace nacre::test {

/// How the errors of many cases are spread: |got - double| / max(1, ρ), of each case its worst channel.
struct Spread {
    double median = 0.0, p90 = 0.0, p99 = 0.0, p999 = 0.0, worst = 0.0;
    Input worstInput{};
};

/// The accuracy of one quantity in one region.
struct Measurement {
    std::string driver;    ///< How the context came about, or what else was measured: see `inputsAlone`.
    std::string renderer;  ///< The driver's own name.
    std::string region, quantity;
    std::uint64_t cases = 0;
    std::uint64_t atJump = 0;  ///< Left out of the spread: the inputs lie on both sides of a jump of the model.
    Spread spread;
};

/// What stands in Measurement::driver for the floor below every driver: see halfUlpSensitivity.
extern const char* const inputsAlone;

/// The GLSL on one driver against the double-precision model; ρ, then the diffuse coefficient, of every region.
/// options: how the GLSL is assembled.
Result<std::vector<Measurement>> measureDriver(const demo::Context& context, const std::string& driver, std::size_t cases,
                                               std::uint64_t seed, const PointProgram::Options& options = {});

/// The same for cases of one region, ρ alone.
Result<Measurement> measureRegion(const demo::Context& context, const Region& region, std::size_t cases, std::uint64_t seed,
                                  const PointProgram::Options& options);

/// How far the double-precision model itself moves when every number of the input moves by half an ulp.
std::vector<Measurement> measureInputs(std::size_t cases, std::uint64_t seed);

}  // namespace nacre::test
