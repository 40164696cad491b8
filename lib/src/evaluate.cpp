#include <nacre/evaluate.hpp>

#include <limits>
#include <string>

#include <nacre/validate.hpp>

#include "model/physical.hpp"
#include "model/surface.hpp"

namespace nacre {
namespace {

bool isFinite(glm::dvec3 a)
{
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

Error notFinite(const char* function, const char* argument)
{
    return {std::string("nacre::") + function + "(): expected a finite " + argument};
}

}  // namespace

Result<Surface> surface(const Material& material, glm::dvec3 normal, glm::dvec4 tangent, glm::dvec3 objectPosition,
                        const glm::dmat3& normalToShading)
{
    const std::vector<Fault> faults = validate(material);
    if (!faults.empty()) return Error{"nacre::surface(): " + faults.front().message};
    if (!isFinite(normal)) return notFinite("surface", "normal");
    if (!isFinite(objectPosition)) return notFinite("surface", "objectPosition");
    if (!isFinite(glm::dvec3(tangent)) || !std::isfinite(tangent.w)) return notFinite("surface", "tangent");
    if (!isFinite(normalToShading[0]) || !isFinite(normalToShading[1]) || !isFinite(normalToShading[2])) {
        return notFinite("surface", "normalToShading");
    }

    const model::Surface s = model::surface(model::derive(material), normal, tangent, objectPosition, normalToShading);
    return Surface{s.upperNormal, s.lowerNormal, s.thicknessUm * 1000.0};
}

Result<Evaluation> evaluate(const Material& material, const Surface& surface, glm::dvec3 light, glm::dvec3 view,
                            const FringeTable* fringeTable)
{
    const std::vector<Fault> faults = validate(material);
    if (!faults.empty()) return Error{"nacre::evaluate(): " + faults.front().message};
    if (!isFinite(surface.upperNormal)) return notFinite("evaluate", "upperNormal");
    if (!isFinite(surface.lowerNormal)) return notFinite("evaluate", "lowerNormal");
    if (!isFinite(light)) return notFinite("evaluate", "light");
    if (!isFinite(view)) return notFinite("evaluate", "view");
    if (!(surface.thicknessNm >= 0.0 && std::isfinite(surface.thicknessNm))) {
        return Error{"nacre::evaluate(): expected a finite thicknessNm >= 0, got " + std::to_string(surface.thicknessNm)};
    }

    const model::Material m = model::derive(material);
    const model::Surface s{surface.upperNormal, surface.lowerNormal, surface.thicknessNm / 1000.0};
    const model::PhysicalView physical = model::physicalView(m, s, view, fringeTable);
    const model::View w = model::view(m, s, view);
    const model::Terms t = model::terms(m, w, light);
    const bool hasNormals = dot(w.upperNormal, w.upperNormal) > 0.0 && dot(w.lowerNormal, w.lowerNormal) > 0.0;

    Evaluation e;
    if (material.quality == Quality::paper) {
        e.rho = model::interference(t.sqrtR, t.sqrtT, model::cosPhase(t.cycles));
        e.R = t.sqrtR * t.sqrtR;
        e.T = t.sqrtT * t.sqrtT;
        const glm::dvec3 cosPhase = model::cosPhase(model::pathCycles(w.path, glm::dvec3(2.0)));
        e.diffuse = hasNormals ? model::diffuseCoefficient(m.diffuseFringe, cosPhase) : glm::dvec3(0.0);
        e.shaded = model::light(m, w, light);
    } else {
        const model::PhysicalTerms p = model::physicalTerms(m, physical, light);
        e.rho = model::physicalSpecular(m, physical, p, fringeTable);
        for (int channel = 0; channel < 3; ++channel) {
            const model::Film film = model::filmOf(m, p, channel);
            e.R[channel] = film.upper * p.rootUpper * p.rootUpper;
            e.T[channel] = film.lower * p.rootLower[channel] * p.rootLower[channel];
        }
        model::Material unweighted = m;
        unweighted.diffuseWeight = 1.0;
        e.diffuse = hasNormals ? model::physicalDiffuse(unweighted, s.thicknessUm, fringeTable) : glm::dvec3(0.0);
        e.shaded = model::physicalWeighted(m, physical, light, e.rho);
    }
    const double cosTheta = glm::clamp(dot(w.upperNormal, light), 0.0, 1.0);
    const glm::dvec3 inside = model::refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta);
    const glm::bvec3 hasRays = greaterThan(min(inside, w.cosRefracted), glm::dvec3(0.0));
    e.phi = mix(glm::dvec3(0.0), glm::pi<double>() * t.cycles, hasRays);
    e.meanCos = model::meanRefractedCosine(m.eta, m.oneMinusEtaSquared, m.normalReflectance);
    e.meanCos = mix(e.meanCos, glm::dvec3(std::numeric_limits<double>::quiet_NaN()),
                    lessThan(m.oneMinusEtaSquared, glm::dvec3(0.0)));
    return e;
}

}  // namespace nacre
