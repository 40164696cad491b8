#include "gpu_evaluator.hpp"

#include <algorithm>

namespace nacre::test {
namespace {

constexpr int targets = 8;

const char* const everyTerm = R"(
layout(location = 0) out vec3 rho;
layout(location = 1) out vec3 R;
layout(location = 2) out vec3 T;
layout(location = 3) out vec3 phi;
layout(location = 4) out vec3 diffuse;
layout(location = 5) out vec3 meanCos;
layout(location = 6) out vec3 shaded;
layout(location = 7) out vec3 lobes;

void main()
{
    nacre_Material m = pointMaterial();
    nacre_Surface s = pointSurface();
    vec3 l = pointLight();

    nacre_View w = nacre_view(m, s, pointView());
    nacre_Terms t = nacre_terms(m, w, l);
    rho = nacre_specular(m, w, l);
    R = t.sqrtR * t.sqrtR;
    T = t.sqrtT * t.sqrtT;
    vec3 inside = nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, clamp(dot(w.upperNormal, l), 0.0, 1.0));
    bvec3 hasRays = greaterThan(min(inside, w.cosRefracted), vec3(0.0));
    // Whole cycles and all, which the library leaves out.
    vec3 cycles = (m.cyclesPerUm + m.cyclesPerUmTail) * s.thicknessUm * (sqrt(max(inside, 0.0)) + w.cosRefracted);
    phi = mix(vec3(0.0), 3.14159265 * cycles, hasRays);
    diffuse = w.diffuse;
    meanCos = nacre_meanRefractedCosine(m.eta, m.oneMinusEtaSquared, m.normalReflectance);
    shaded = nacre_light(m, w, l);
    lobes = vec3(t.upperOneMinus, t.lowerOneMinus.r, t.lowerOneMinus.b);
}
)";

}  // namespace

Result<GpuEvaluator> GpuEvaluator::create(const demo::Context& context)
{
    Result<PointProgram> program = PointProgram::create(context, everyTerm, targets);
    if (!program) return program.error();
    return GpuEvaluator(std::move(*program));
}

Result<std::vector<GpuOutput>> GpuEvaluator::run(const std::vector<GpuInput>& inputs) const
{
    constexpr std::size_t most = PointProgram::most;
    std::vector<Block> blocks(std::min(most, inputs.size()));
    std::vector<GpuPoint> points(blocks.size());
    std::vector<glm::vec4> pixels(blocks.size());
    std::vector<GpuOutput> outputs(inputs.size());

    for (std::size_t first = 0; first < inputs.size(); first += most) {
        const std::size_t count = std::min(most, inputs.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const GpuInput& input = inputs[first + i];
            blocks[i] = input.block;
            points[i] = {input.light, input.thicknessUm, input.view, static_cast<float>(i), input.upperNormal, 0.0F, input.lowerNormal, 0.0F};
        }
        program_.setMaterials(blocks.data(), count);
        program_.draw(points.data(), count);
        glm::vec3 GpuOutput::*const members[targets] = {&GpuOutput::rho,     &GpuOutput::R,       &GpuOutput::T,     &GpuOutput::phi,
                                                        &GpuOutput::diffuse, &GpuOutput::meanCos, &GpuOutput::shaded, &GpuOutput::lobes};
        for (int target = 0; target < targets; ++target) {
            program_.read(target, pixels.data(), count);
            for (std::size_t i = 0; i < count; ++i) outputs[first + i].*members[target] = pixels[i];
        }
    }
    if (Outcome outcome = program_.check(); !outcome) return outcome.error();
    return outputs;
}

}  // namespace nacre::test
