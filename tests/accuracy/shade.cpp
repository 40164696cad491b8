#include "shade.hpp"

namespace nacre::test {
namespace {

const char* const rhoAndDiffuse = R"(
layout(location = 0) out vec4 rho;
layout(location = 1) out vec4 diffuse;

void main()
{
    nacre_View w = nacre_view(pointMaterial(), pointSurface(), pointView());
    rho = vec4(nacre_specular(pointMaterial(), w, pointLight()), 1.0);
    // The coefficient is the layer's wherever the viewer is; seen from above, so that no rounding hides it.
    nacre_Surface s = pointSurface();
    diffuse = vec4(nacre_view(pointMaterial(), s, nacre_direction(s.upperNormal)).diffuse, 1.0);
}
)";

}  // namespace

Result<Shade> Shade::create(const demo::Context& context, const PointProgram::Options& options)
{
    Result<PointProgram> program = PointProgram::create(context, rhoAndDiffuse, 2, options);
    if (!program) return program.error();
    return Shade(std::move(*program));
}

Outcome Shade::run(const std::vector<Block>& materials, const std::vector<GpuPoint>& points, std::vector<glm::vec4>& rho,
                   std::vector<glm::vec4>& diffuse) const
{
    rho.resize(points.size());
    diffuse.resize(points.size());
    program_.setMaterials(materials.data(), materials.size());
    program_.draw(points.data(), points.size());
    program_.read(0, rho.data(), rho.size());
    program_.read(1, diffuse.data(), diffuse.size());
    return program_.check();
}

}  // namespace nacre::test
