#pragma once

#include "inputs.hpp"
#include "model/layered.hpp"
#include "random.hpp"

namespace nacre::test {

/// The double-precision results of one evaluation that the GLSL is held against.
struct Reference {
    glm::dvec3 rho, diffuse;
};

/// Straight from the model: nothing is validated, the material is derived by the caller, once for many
/// points. Light and view are normalised, as nacre-eval does.
Reference evaluate(const model::Material& material, const GpuPoint& point);
Reference evaluate(const Input& input);

/// What the double-precision ρ of one channel can be where every number of the input is uncertain.
struct Neighbourhood {
    double least, most;
    bool crossesJump;  ///< The inputs lie on both sides of one of the model's jumps: see `switches`.
};

/// Moves every number of `input` by up to `ulps` of its own, one by one, all together in the directions that
/// change ρ most or that lead to a jump, and at random. Light and view are not normalised again. It ends early
/// once the range comes within `tolerance` of `accepted`.
Neighbourhood neighbourhood(const Input& input, int channel, int ulps, double accepted, double tolerance);

/// The largest change of ρ and of the diffuse coefficient when every number of the input moves by half an
/// ulp, one by one and in random combinations; per max(1, ρ), the worst channel.
struct Sensitivity {
    double rho, diffuse;
};
Sensitivity halfUlpSensitivity(const Input& input);

}  // namespace nacre::test
