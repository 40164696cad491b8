#pragma once

#include <vector>

#include "point_program.hpp"

namespace nacre::test {

/// One evaluation as the shader gets it: everything in float32.
struct GpuInput {
    Block block;
    glm::vec3 light, view, upperNormal, lowerNormal;
    float thicknessUm;
};

/// Where quality `physical` has its fringes from.
enum class FringeForm { table, analytic };

/// What the shader makes of it: the members of nacre::Evaluation, and of nacre_Terms 1 - the lobes' cosines
/// (upper, lower red) and the path's cycles (blue).
struct GpuOutput {
    glm::vec3 rho, R, T, phi, diffuse, meanCos, shaded, lobes;
};

/// Runs the library's GLSL, unmodified, of the quality that each block asks for, once per input in a fragment
/// shader with float32 targets.
class GpuEvaluator {
public:
    static Result<GpuEvaluator> create(const demo::Context& context, FringeForm form = FringeForm::table);

    /// As many outputs as inputs, in their order. Fails where the driver reports an error.
    Result<std::vector<GpuOutput>> run(const std::vector<GpuInput>& inputs) const;

private:
    explicit GpuEvaluator(PointProgram program) : program_(std::move(program)) {}
    PointProgram program_;
    GLuint fringeTable_ = 0;  // 0: the sampler-free form
};

}  // namespace nacre::test
