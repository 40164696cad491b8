#pragma once

#include "airy.hpp"
#include "fringe.hpp"
#include "layered.hpp"
#include "physical_lobes.hpp"

namespace nacre::model {

struct PhysicalView {
    View layer;
    dvec3 crossingS, crossingP;
    dvec3 pathAtNormal;
    dvec3 lowerScale;
    dvec3 pathPerRadian;
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

// As the shaders have it where the thickness is constant: the host's.
inline dvec3 physicalDiffuse(const Material& m, dvec3 cosine)
{
    const dvec3 fringe = (1.0 + m.diffuseFringe * clamp(cosine, -1.0, 1.0)) / (1.0 + m.diffuseFringe);
    return m.diffuseAlbedo * fringe * (glm::one_over_pi<double>() * m.diffuseWeight);
}

inline dvec3 physicalDiffuse(const Material& m, double thicknessUm, const FringeTable* table)
{
    const dvec3 path = 2.0 * m.index * thicknessUm;
    return physicalDiffuse(m, table ? firstFringe(*table, path) : firstFringe(path));
}

inline PhysicalView physicalView(const Material& m, const Surface& s, dvec3 v, const FringeTable* table)
{
    PhysicalView w;
    w.layer = viewOfSurface(m, s, v);
    crossings(m.eta, w.layer.cosTheta, w.layer.cosRefracted, w.crossingS, w.crossingP);
    w.pathAtNormal = m.index * s.thicknessUm;
    w.pathPerRadian = m.index / m.cyclesPerUm / glm::two_pi<double>();
    w.lowerScale = m.lobes == 1 ? m.lowerScale * lowerLobeScale(m.eta, length(w.layer.upperAcross), m.lowerExponent) : dvec3(1.0);
    w.diffuse = w.layer.cosTheta > 0.0 ? physicalDiffuse(m, s.thicknessUm, table) : dvec3(0.0);
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
        const dvec3 cosRefracted = refractedCosine(refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta));
        const double upper = upperLobeOneMinus(o.upperNormal, halfVector, cosTheta, o.cosTheta);

        const dvec3 lowerCosineI = lowerCosine(m.eta, o.cosBetween, cosTheta, dot(o.lowerNormal, l), cosRefracted);
        const dvec2 halfAcross(dot(o.frameX, halfVector), dot(o.frameY, halfVector));
        const dvec3 lower = lowerLobeOneMinus(m.eta, halfAcross, o.upperAcross, cosTheta + o.cosTheta,
                                              cosRefracted + o.cosRefracted, lowerCosineI - o.lowerCosine);
        // The three null conditions under Eq 10.
        const glm::bvec3 meets = lessThan(max(lower - 1.0, max(lowerCosineI, o.lowerCosine)), dvec3(0.0));
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

inline Film filmOf(const Material& m, const PhysicalTerms& t, int channel)
{
    const double eta = m.eta[channel], etaSquared = m.etaSquared[channel], oneMinusEtaSquared = m.oneMinusEtaSquared[channel];
    dvec2 crossing(t.crossingS[channel], t.crossingP[channel]);
    const double cosSquared = oneMinusEtaSquared + etaSquared * t.cosHalfSquared;
    const double sineSquared = etaSquared * (1.0 - t.cosHalfSquared);
    const double cosRefracted = std::sqrt(std::fmax(cosSquared, 0.0));
    dvec2 a = upperAmplitudes(eta, oneMinusEtaSquared, std::sqrt(t.cosHalfSquared), cosRefracted);
    const bool reflectsAll = cosSquared < 0.0;
    a = reflectsAll ? dvec2(1.0) : a;
    crossing = reflectsAll ? dvec2(0.0) : crossing;
    const Complex substrate(m.substrateReal[channel], m.substrateImaginary[channel]);
    Film film;
    if (m.substrate == 1) {
        const ComplexPair b = lowerAmplitudesMetal(substrate, sineSquared, cosRefracted);
        film.ratio = {-a.x * b.s, -a.y * b.p};
        weigh(film, a * a, dvec2(std::norm(b.s), std::norm(b.p)), crossing);
    } else {
        const dvec2 b = lowerAmplitudes(substrate.real(), sineSquared, cosRefracted);
        film.ratio = {-a.x * b.x, -a.y * b.y};
        weigh(film, a * a, b * b, crossing);
    }
    return film;
}

// The form without a table, of any number of orders.
template <std::size_t Orders>
double fringesOf(const Material& m, const Film& film, double path, int channel)
{
    const Fringe<Orders> cosine = cosineFringe<Orders>(path);
    return m.substrate == 1 ? fringeSumMetal(film, cosine, sineFringe<Orders>(path), channel) : fringeSum(film, cosine)[channel];
}

inline dvec3 physicalSpecular(const Material& m, const PhysicalView& w, const PhysicalTerms& t, const FringeTable* table)
{
    dvec3 rho;
    for (int channel = 0; channel < 3; ++channel) {
        const Film film = filmOf(m, t, channel);
        const double fringes = table ? fringeSum(*table, film, t.path[channel], w.pathPerRadian[channel])[channel]
                                     : fringesOf<defaultOrders>(m, film, t.path[channel], channel);
        rho[channel] = filmReflectance(film, dvec3(fringes), t.rootUpper, t.rootLower[channel])[channel];
    }
    return rho;
}

inline dvec3 physicalWeighted(const Material& m, const PhysicalView& w, dvec3 l, dvec3 specular)
{
    const dvec3 both = w.diffuse + m.specularWeight * specular;
    return both * glm::clamp(dot(w.layer.upperNormal, l), 0.0, 1.0);
}

}  // namespace nacre::model
