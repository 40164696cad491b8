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

inline View view(const Material& m, const Surface& s, dvec3 v)
{
    View w;
    w.direction = v;
    w.upperNormal = direction(s.upperNormal);
    w.lowerNormal = direction(s.lowerNormal);
    const bool hasNormals = dot(w.upperNormal, w.upperNormal) > 0.0 && dot(w.lowerNormal, w.lowerNormal) > 0.0;
    const double cosTheta = dot(w.upperNormal, v);
    w.cosTheta = hasNormals && cosTheta > 0.0 ? std::fmin(cosTheta, 1.0) : 0.0;
    w.cosBetween = dot(w.upperNormal, w.lowerNormal);
    frame(w.lowerNormal, w.frameX, w.frameY);
    w.upperAcross = dvec2(dot(w.upperNormal, w.frameX), dot(w.upperNormal, w.frameY));

    const dvec3 cosSquared = refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, w.cosTheta);
    w.cosRefracted = sqrt(max(cosSquared, 0.0));
    w.lowerCosine = lowerCosine(m.eta, w.cosBetween, w.cosTheta, dot(w.lowerNormal, v), w.cosRefracted);
    const dvec3 transmittance = (1.0 - m.normalReflectance) * transmittanceShape(w.cosRefracted);
    const glm::bvec3 leaves = lessThan(w.lowerCosine, dvec3(0.0));
    w.sqrtTransmittance = mix(dvec3(0.0), sqrt(max(transmittance, 0.0)), leaves);

    w.path = path(m.cyclesPerUm, s.thicknessUm);
    const dvec3 cosine = cosPhase(pathCycles(w.path, dvec3(2.0)));
    w.diffuse = hasNormals ? diffuseCoefficient(m.diffuseFringe, cosine) : dvec3(0.0);
    return w;
}

inline Terms terms(const Material& m, const View& w, dvec3 l)
{
    Terms t{dvec3(0.0), dvec3(0.0), dvec3(0.0), 1.0, dvec3(1.0)};
    const double cosTheta = std::fmin(dot(w.upperNormal, l), 1.0);
    if (cosTheta > 0.0 && w.cosTheta > 0.0) {
        const dvec3 halfVector = l + w.direction;

        const dvec3 cosSquared = refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta);
        const glm::bvec3 reflectsAll = lessThan(cosSquared, dvec3(0.0));
        const dvec3 cosRefracted = sqrt(max(cosSquared, 0.0));

        t.upperOneMinus = upperLobeOneMinus(w.upperNormal, halfVector, cosTheta, w.cosTheta);
        const dvec3 reflected = mix(reflectance(m.normalReflectance, cosTheta), dvec3(1.0), reflectsAll);
        t.sqrtR = sqrt(reflected) * powerOneMinus(t.upperOneMinus, 0.5 * m.upperExponent);

        const dvec3 lowerCosineI = lowerCosine(m.eta, w.cosBetween, cosTheta, dot(w.lowerNormal, l), cosRefracted);
        const dvec2 halfAcross(dot(w.frameX, halfVector), dot(w.frameY, halfVector));
        t.lowerOneMinus = lowerLobeOneMinus(m.eta, halfAcross, w.upperAcross, cosTheta + w.cosTheta,
                                            cosRefracted + w.cosRefracted, lowerCosineI - w.lowerCosine);
        const dvec3 transmittance = (1.0 - m.normalReflectance) * transmittanceShape(cosTheta);
        dvec3 sqrtT = sqrt(transmittance) * w.sqrtTransmittance * powerOneMinus(t.lowerOneMinus, 0.5 * m.lowerExponent);
        // The three null conditions under Eq 10; the viewer's is in w.sqrtTransmittance.
        sqrtT = mix(dvec3(0.0), sqrtT, lessThan(lowerCosineI, dvec3(0.0)));
        sqrtT = mix(dvec3(0.0), sqrtT, lessThan(t.lowerOneMinus, dvec3(1.0)));
        t.sqrtT = mix(sqrtT, dvec3(0.0), reflectsAll);

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
    const double cosTheta = w.cosTheta > 0.0 ? glm::clamp(dot(w.upperNormal, l), 0.0, 1.0) : 0.0;
    return (m.specularWeight * specular(m, w, l) + m.diffuseWeight * w.diffuse) * cosTheta;
}

}  // namespace nacre::model
