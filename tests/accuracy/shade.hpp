#pragma once

#include <vector>

#include "point_program.hpp"

namespace nacre::test {

/// ρ and the diffuse coefficient by the library's GLSL.
class Shade {
public:
    static Result<Shade> create(const demo::Context& context, const PointProgram::Options& options = {});

    /// At most PointProgram::most points and materials. The vectors are resized to the points; w is 1.
    Outcome run(const std::vector<Block>& materials, const std::vector<GpuPoint>& points, std::vector<glm::vec4>& rho,
                std::vector<glm::vec4>& diffuse) const;

private:
    explicit Shade(PointProgram program) : program_(std::move(program)) {}
    PointProgram program_;
};

}  // namespace nacre::test
