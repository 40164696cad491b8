#pragma once

#include "airy.hpp"
#include "fringe.hpp"
#include "layered.hpp"
#include "physical_lobes.hpp"

namespace nacre::model {

struct PhysicalView {
    View layer;
    dvec3 crossingS, crossingP;
    dvec3 lowerScale;
    dvec3 pathAtNormal;
    dvec3 diffuse;
};

struct PhysicalTerms {
    double rootUpper;
    dvec3 rootLower;
    double cosHalfSquared;
    dvec3 crossingS, crossingP;
    dvec3 path;
};

inline void crossings(dvec3 eta, double cosTheta, dvec3 cosRefracted, dvec3& s, dvec3& p)
{
    const dvec2 r = crossing(eta.x, cosTheta, cosRefracted.x);
    const dvec2 g = crossing(eta.y, cosTheta, cosRefracted.y);
    const dvec2 b = crossing(eta.z, cosTheta, cosRefracted.z);
    s = dvec3(r.x, g.x, b.x);
    p = dvec3(r.y, g.y, b.y);
}

inline dvec3 physicalDiffuse(const Material& m, dvec3 cosine)
{
    const dvec3 fringe = (1.0 + m.diffuseFringe * clamp(cosine, -1.0, 1.0)) / (1.0 + m.diffuseFringe);
    return m.diffuseAlbedo * fringe * glm::one_over_pi<double>();
}

inline PhysicalView physicalView(const Material& m, const Surface& s, dvec3 v, const FringeTable* table)
{
    PhysicalView w;
    w.layer = view(m, s, v);
    crossings(m.eta, w.layer.cosTheta, w.layer.cosRefracted, w.crossingS, w.crossingP);
    w.lowerScale = m.lobes == 1 ? m.lowerScale * lowerLobeScale(m.eta, w.layer.upperAcross, m.lowerExponent) : dvec3(1.0);
    w.pathAtNormal = m.index * s.thicknessUm;
    w.diffuse = dvec3(0.0);
    if (w.layer.cosTheta > 0.0) w.diffuse = physicalDiffuse(m, cosineFringe<1>(table, 2.0 * w.pathAtNormal).order[0]);
    return w;
}

inline PhysicalTerms physicalTerms(const Material& m, const PhysicalView& w, dvec3 l)
{
    PhysicalTerms t{0.0, dvec3(0.0), 1.0, dvec3(0.0), dvec3(0.0), dvec3(0.0)};
    const View& o = w.layer;
    const double cosTheta = std::fmin(dot(o.upperNormal, l), 1.0);
    if (cosTheta > 0.0 && o.cosTheta > 0.0) {
        const dvec3 halfVector = l + o.direction;
        t.cosHalfSquared = std::fmin(0.25 * dot(halfVector, halfVector), 1.0);
        const double steepest = std::fmax(cosTheta, o.cosTheta);
        const bool isBelow = any(lessThan(m.oneMinusEtaSquared, dvec3(0.0)));
        t.cosHalfSquared = isBelow ? std::fmax(t.cosHalfSquared, steepest * steepest) : t.cosHalfSquared;
        const dvec3 cosSquared = refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta);
        const dvec3 cosRefracted = sqrt(max(cosSquared, 0.0));
        const double upper = upperLobeOneMinus(o.upperNormal, halfVector, cosTheta, o.cosTheta);

        const dvec3 lowerCosineI = lowerCosine(m.eta, o.cosBetween, cosTheta, dot(o.lowerNormal, l), cosRefracted);
        const dvec2 halfAcross(dot(o.frameX, halfVector), dot(o.frameY, halfVector));
        const dvec3 lower = lowerLobeOneMinus(m.eta, halfAcross, o.upperAcross, cosTheta + o.cosTheta,
                                              cosRefracted + o.cosRefracted, lowerCosineI - o.lowerCosine);
        // The three null conditions under Eq 10.
        const dvec3 worst = max(lower - 1.0, max(lowerCosineI, o.lowerCosine));
        const glm::bvec3 meets = lessThan(worst, dvec3(0.0));
        t.rootUpper = powerOneMinus(upper, 0.5 * m.upperExponent);
        t.rootLower = mix(dvec3(0.0), powerOneMinus(lower, 0.5 * m.lowerExponent), meets);
        if (m.lobes == 1) {
            t.rootUpper *= m.upperScale / std::sqrt(lobeFlattening(m.upperExponent, std::fmax(cosTheta, o.cosTheta)));
            t.rootLower *= w.lowerScale / sqrt(max(lobeFlattening(m.lowerExponent, max(cosRefracted, o.cosRefracted)), dvec3(1e-18)));
        }

        crossings(m.eta, cosTheta, cosRefracted, t.crossingS, t.crossingP);
        t.crossingS *= w.crossingS;
        t.crossingP *= w.crossingP;
        t.path = w.pathAtNormal * (cosRefracted + o.cosRefracted);
    }
    return t;
}

inline Film filmOf(double eta, double oneMinusEtaSquared, Complex substrate, int kind, double cosHalfSquared, dvec2 crossing)
{
    const double cosSquared = oneMinusEtaSquared + eta * eta * cosHalfSquared;
    const double sineSquared = eta * eta * (1.0 - cosHalfSquared);
    const double cosRefracted = std::sqrt(std::fmax(cosSquared, 0.0));
    dvec2 a = upperAmplitudes(eta, oneMinusEtaSquared, std::sqrt(cosHalfSquared), cosRefracted);
    const bool reflectsAll = cosSquared < 0.0;
    a = reflectsAll ? dvec2(1.0) : a;
    crossing = reflectsAll ? dvec2(0.0) : crossing;
    if (kind == 1) {
        const ComplexPair b = lowerAmplitudesMetal(substrate, sineSquared, cosRefracted);
        return film(a, dvec2(std::norm(b.s), std::norm(b.p)), {-a.x * b.s, -a.y * b.p}, crossing);
    }
    const dvec2 b = lowerAmplitudes(substrate.real(), sineSquared, cosRefracted);
    const dvec2 q = -a * b;
    return film(a, b * b, {q.x, q.y}, crossing);
}

inline Film filmOf(const Material& m, const PhysicalTerms& t, int channel)
{
    return filmOf(m.eta[channel], m.oneMinusEtaSquared[channel], Complex(m.substrateReal[channel], m.substrateImaginary[channel]),
                  m.substrate, t.cosHalfSquared, dvec2(t.crossingS[channel], t.crossingP[channel]));
}

template <std::size_t Orders>
double filmChannel(const Film& film, int kind, const std::array<double, Orders>& cosine, const std::array<double, Orders>& sine,
                   double coherence, double rootUpper, double rootLower)
{
    double fringes = 0.0;
    if (kind == 1) {
        std::array<Complex, Orders> c;
        for (std::size_t m = 0; m < Orders; ++m) c[m] = Complex(cosine[m], sine[m]);
        fringes = fringeSumMetal(film, c, coherence);
    } else {
        fringes = fringeSum(film, cosine, coherence);
    }
    return filmReflectance(film, fringes, rootUpper, rootLower);
}

template <std::size_t Orders>
dvec3 filmSpecular(const Material& m, const PhysicalTerms& t, const Fringe<Orders>& cosine, const Fringe<Orders>& sine)
{
    dvec3 rho;
    for (int channel = 0; channel < 3; ++channel) {
        std::array<double, Orders> c, s;
        for (std::size_t order = 0; order < Orders; ++order) {
            c[order] = cosine.order[order][channel];
            s[order] = sine.order[order][channel];
        }
        rho[channel] = filmChannel(filmOf(m, t, channel), m.substrate, c, s, cosine.coherence[channel], t.rootUpper, t.rootLower[channel]);
    }
    return rho;
}

inline dvec3 physicalSpecular(const Material& m, const PhysicalTerms& t, const FringeTable* table)
{
    const auto cosine = cosineFringe<defaultOrders>(table, t.path);
    auto sine = cosine;
    if (m.substrate == 1) sine = sineFringe<defaultOrders>(table, t.path);
    return filmSpecular(m, t, cosine, sine);
}

inline dvec3 physicalWeighted(const Material& m, const PhysicalView& w, dvec3 l, dvec3 specular)
{
    const double cosTheta = w.layer.cosTheta > 0.0 ? glm::clamp(dot(w.layer.upperNormal, l), 0.0, 1.0) : 0.0;
    return (m.specularWeight * specular + m.diffuseWeight * w.diffuse) * cosTheta;
}

}  // namespace nacre::model
