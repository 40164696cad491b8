#pragma once

#include "diffuse.hpp"
#include "direction.hpp"
#include "fresnel.hpp"
#include "interference.hpp"
#include "lower_lobe.hpp"
#include "phase.hpp"
#include "power.hpp"
#include "upper_lobe.hpp"

namespace nacre::model {

struct View {
    dvec3 direction;
    dvec3 upperNormal;
    dvec3 lowerNormal;
    double cosTheta;
    double cosBetween;
    dvec3 frameX;
    dvec3 frameY;
    dvec2 upperAcross;
    dvec3 cosRefracted;
    dvec3 lowerCosine;
    dvec3 sqrtTransmittance;
    Path path;
    dvec3 diffuse;
};

struct Terms {
    dvec3 sqrtR;
    dvec3 sqrtT;
    dvec3 cycles;
    double upperOneMinus;
    dvec3 lowerOneMinus;
};

inline dvec3 sqrtTransmittanceOut(const Material& m, const View& w)
{
    const dvec3 root = (1.0 - m.normalReflectance) * sqrt(max(transmittanceShape(w.cosRefracted), 0.0));
    return mix(dvec3(0.0), root, lessThan(w.lowerCosine, dvec3(0.0)));
}

// The GLSL's nacre_viewThroughLayer stands in it.
inline View viewOfSurface(const Material& m, const Surface& s, dvec3 v)
{
    View w{};
    w.direction = v;
    w.upperNormal = direction(s.upperNormal);
    const double cosTheta = dot(w.upperNormal, v);
    w.cosTheta = cosTheta > 0.0 ? std::fmin(cosTheta, 1.0) : 0.0;
    w.cosRefracted = refractedCosine(refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, w.cosTheta));
    w.lowerNormal = direction(s.lowerNormal);
    if (!(dot(w.lowerNormal, w.lowerNormal) > 0.0)) w.cosTheta = 0.0;
    w.cosBetween = dot(w.upperNormal, w.lowerNormal);
    frame(w.lowerNormal, w.frameX, w.frameY);
    w.upperAcross = dvec2(dot(w.upperNormal, w.frameX), dot(w.upperNormal, w.frameY));
    w.lowerCosine = lowerCosine(m.eta, w.cosBetween, w.cosTheta, dot(w.lowerNormal, w.direction), w.cosRefracted);
    return w;
}

inline View view(const Material& m, const Surface& s, dvec3 v)
{
    View w = viewOfSurface(m, s, v);
    w.sqrtTransmittance = sqrtTransmittanceOut(m, w);
    w.path = path(m.cyclesPerUm, s.thicknessUm);
    const dvec3 cosine = cosPhase(pathCycles(w.path, dvec3(2.0)));
    w.diffuse = w.cosTheta > 0.0 ? m.diffuseWeight * diffuseCoefficient(m.diffuseFringe, cosine) : dvec3(0.0);
    return w;
}

inline Terms terms(const Material& m, const View& w, dvec3 l)
{
    Terms t{dvec3(0.0), dvec3(0.0), dvec3(0.0), 1.0, dvec3(1.0)};
    const double cosTheta = std::fmin(dot(w.upperNormal, l), 1.0);
    if (cosTheta > 0.0 && w.cosTheta > 0.0) {
        const dvec3 halfVector = l + w.direction;

        const dvec3 cosSquared = refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta);
        const dvec3 cosRefracted = refractedCosine(cosSquared);

        t.upperOneMinus = upperLobeOneMinus(w.upperNormal, halfVector, cosTheta, w.cosTheta);
        const glm::bvec3 reflectsAll = lessThan(cosSquared, dvec3(0.0));
        const dvec3 reflected = mix(reflectance(m.normalReflectance, cosTheta), dvec3(1.0), reflectsAll);
        t.sqrtR = sqrt(reflected) * powerOneMinus(t.upperOneMinus, 0.5 * m.upperExponent);

        const dvec3 lowerCosineI = lowerCosine(m.eta, w.cosBetween, cosTheta, dot(w.lowerNormal, l), cosRefracted);
        const dvec2 halfAcross(dot(w.frameX, halfVector), dot(w.frameY, halfVector));
        t.lowerOneMinus = lowerLobeOneMinus(m.eta, halfAcross, w.upperAcross, cosTheta + w.cosTheta,
                                            cosRefracted + w.cosRefracted, lowerCosineI - w.lowerCosine);
        // The three null conditions under Eq 10, of which the viewer's is in w.sqrtTransmittance: the light's ray, the lobe.
        const glm::bvec3 meets = lessThan(max(lowerCosineI, t.lowerOneMinus - 1.0), dvec3(0.0));
        const dvec3 lobe = powerOneMinus(t.lowerOneMinus, 0.5 * m.lowerExponent);
        t.sqrtT = mix(dvec3(0.0), std::sqrt(transmittanceShape(cosTheta)) * w.sqrtTransmittance * lobe, meets);
        t.sqrtT = mix(t.sqrtT, dvec3(0.0), reflectsAll);

        t.cycles = pathCycles(w.path, cosRefracted + w.cosRefracted);
    }
    return t;
}

inline dvec3 specular(const Material& m, const View& w, dvec3 l)
{
    const Terms t = terms(m, w, l);
    return interference(t.sqrtR, t.sqrtT, cosPhase(t.cycles));
}

inline dvec3 light(const Material& m, const View& w, dvec3 l)
{
    const dvec3 both = w.diffuse + m.specularWeight * specular(m, w, l);
    return both * glm::clamp(dot(w.upperNormal, l), 0.0, 1.0);
}

}  // namespace nacre::model
