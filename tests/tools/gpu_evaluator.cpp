#include "gpu_evaluator.hpp"

#include <algorithm>

#include "gl/fringe_texture.hpp"

namespace nacre::test {
namespace {

constexpr int targets = 8;
constexpr int fringeUnit = 2;  // the inputs take the first two

const char* const everyTerm = R"(
#if FRINGE_TABLE == 1
uniform sampler2D fringeTable;
#define FRINGE_ARGUMENT , fringeTable
#else
#define FRINGE_ARGUMENT
#endif
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
    // The coefficient is the layer's, wherever the viewer is: seen from above, without its weight.
    bool hasNormals = dot(w.upperNormal, w.upperNormal) > 0.0 && dot(w.lowerNormal, w.lowerNormal) > 0.0;
    nacre_Material unweighted = m;
    unweighted.diffuseWeight = 1.0;
    if (m.quality == NACRE_QUALITY_PHYSICAL) {
        nacre_PhysicalView physical = nacre_physicalView(m, s, pointView() FRINGE_ARGUMENT);
        nacre_PhysicalTerms p = nacre_physicalTerms(m, physical, l);
        rho = nacre_physicalSpecular(m, physical, l FRINGE_ARGUMENT);
        for (int channel = 0; channel < 3; ++channel) {
            nacre_Film film = nacre_filmOf(m, p, channel);
            R[channel] = film.upper * p.rootUpper * p.rootUpper;
            T[channel] = film.lower * p.rootLower[channel] * p.rootLower[channel];
        }
        diffuse = hasNormals ? nacre_physicalView(unweighted, s, s.upperNormal FRINGE_ARGUMENT).diffuse : vec3(0.0);
        shaded = nacre_physicalLight(m, physical, l FRINGE_ARGUMENT);
    } else {
        rho = nacre_specular(m, w, l);
        R = t.sqrtR * t.sqrtR;
        T = t.sqrtT * t.sqrtT;
        diffuse = hasNormals ? nacre_view(unweighted, s, s.upperNormal).diffuse : vec3(0.0);
        shaded = nacre_light(m, w, l);
    }
    vec3 inside = nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, clamp(dot(w.upperNormal, l), 0.0, 1.0));
    bvec3 hasRays = greaterThan(min(inside, w.cosRefracted), vec3(0.0));
    // Whole cycles and all, which the library leaves out.
    vec3 cycles = (m.cyclesPerUm + m.cyclesPerUmTail) * s.thicknessUm * (sqrt(max(inside, 0.0)) + w.cosRefracted);
    phi = mix(vec3(0.0), 3.14159265 * cycles, hasRays);
    meanCos = nacre_meanRefractedCosine(m.eta, m.oneMinusEtaSquared, m.normalReflectance);
    lobes = vec3(t.upperOneMinus, t.lowerOneMinus.r, t.cycles.b);
}
)";

}  // namespace

Result<GpuEvaluator> GpuEvaluator::create(const demo::Context& context, FringeForm form)
{
    const std::string define = std::string("#define FRINGE_TABLE ") + (form == FringeForm::table ? "1" : "0");
    Result<PointProgram> program = PointProgram::create(context, define + everyTerm, targets, {});
    if (!program) return program.error();
    GpuEvaluator evaluator(std::move(*program));
    if (form == FringeForm::analytic) return evaluator;
    Result<FringeTable> table = FringeTable::create();
    if (!table) return table.error();
    context.gl().ActiveTexture(GL_TEXTURE0 + fringeUnit);
    evaluator.fringeTable_ = demo::makeFringeTexture(context.gl(), *table);
    return evaluator;
}

Result<std::vector<GpuOutput>> GpuEvaluator::run(const std::vector<GpuInput>& inputs) const
{
    constexpr std::size_t most = PointProgram::most;
    std::vector<Block> blocks(std::min(most, inputs.size()));
    std::vector<GpuPoint> points(blocks.size());
    std::vector<glm::vec4> pixels(blocks.size());
    std::vector<GpuOutput> outputs(inputs.size());

    if (fringeTable_ != 0) program_.bindTexture("fringeTable", fringeUnit, fringeTable_);
    for (std::size_t first = 0; first < inputs.size(); first += most) {
        const std::size_t count = std::min(most, inputs.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const GpuInput& input = inputs[first + i];
            blocks[i] = input.block;
            points[i] = {input.light,       input.thicknessUm,      input.view,        static_cast<float>(i),
                         input.upperNormal, choicesOf(input.block), input.lowerNormal, 0.0F};
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
