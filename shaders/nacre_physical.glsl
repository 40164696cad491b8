#ifndef NACRE_PHYSICAL_GLSL
#define NACRE_PHYSICAL_GLSL

// Quality `physical`: the paper's two lobes with a real film between them (nacre_physical_light.glsl). As in
// nacre_layered.glsl the view is computed once, then each light asks for its share. Light and viewer
// may be swapped. Every function that needs fringes has two forms: with the fringe table, or without.

// What depends on material, surface and view, not on the light.
struct nacre_PhysicalView {
    nacre_View layer;           // what both qualities share
    vec3 crossingS, crossingP;  // root of what leaves the layer towards the viewer, per polarisation
    vec3 lowerScale;            // root of what normalises the lower lobe
    vec3 pathAtNormal;          // r1 d, um
    vec3 diffuse;               // BRDF of the diffuse part
};

// What light and view make of each other, before they interfere.
struct nacre_PhysicalTerms {
    float rootUpper;            // sqrt L0
    vec3 rootLower;             // sqrt L1
    float cosHalfSquared;       // of the angle between light and half vector
    vec3 crossingS, crossingP;  // tau: into the layer and out of it
    vec3 path;                  // r1 d (cosTi + cosTo), um
};

// tau of one direction for three channels.
void nacre_crossings(vec3 eta, float cosTheta, vec3 cosRefracted, out vec3 s, out vec3 p)
{
    vec2 r = nacre_crossing(eta.x, cosTheta, cosRefracted.x);
    vec2 g = nacre_crossing(eta.y, cosTheta, cosRefracted.y);
    vec2 b = nacre_crossing(eta.z, cosTheta, cosRefracted.z);
    s = vec3(r.x, g.x, b.x);
    p = vec3(r.y, g.y, b.y);
}

// Diffuse BRDF: Eq 16 with the sensor's fringe in place of one wavelength's, over its greatest value
// (sqrt Rd + sqrt Td)^2, so that it never exceeds the albedo, over pi. cosine: C(2 r1 d).
vec3 nacre_physicalDiffuse(nacre_Material m, vec3 cosine)
{
    vec3 fringe = (1.0 + m.diffuseFringe * clamp(cosine, -1.0, 1.0)) / (1.0 + m.diffuseFringe);
    return m.diffuseAlbedo * fringe * 0.318309886;
}

// The view but for its diffuse part. v: unit vector to the viewer.
nacre_PhysicalView nacre_physicalViewWithoutDiffuse(nacre_Material m, nacre_Surface s, vec3 v)
{
    nacre_PhysicalView w;
#if NACRE_TILT == 0
    s.lowerNormal = s.upperNormal;
#endif
    w.layer = nacre_view(m, s, v);
    nacre_crossings(m.eta, w.layer.cosTheta, w.layer.cosRefracted, w.crossingS, w.crossingP);
    w.lowerScale = m.lobes == 1 ? m.lowerScale * nacre_lowerLobeScale(m.eta, w.layer.upperAcross, m.lowerExponent) : vec3(1.0);
    w.pathAtNormal = m.index * s.thicknessUm;
    w.diffuse = vec3(0.0);
    return w;
}

nacre_PhysicalView nacre_physicalView(nacre_Material m, nacre_Surface s, vec3 v)
{
    nacre_PhysicalView w = nacre_physicalViewWithoutDiffuse(m, s, v);
    if (w.layer.cosTheta > 0.0) w.diffuse = nacre_physicalDiffuse(m, nacre_cosineFringe(2.0 * w.pathAtNormal).order[0]);
    return w;
}

nacre_PhysicalView nacre_physicalView(nacre_Material m, nacre_Surface s, vec3 v, sampler2D fringeTable)
{
    nacre_PhysicalView w = nacre_physicalViewWithoutDiffuse(m, s, v);
    if (w.layer.cosTheta > 0.0) w.diffuse = nacre_physicalDiffuse(m, nacre_cosineFringe(fringeTable, 2.0 * w.pathAtNormal).order[0]);
    return w;
}

// l: unit vector to the light. No lobes where light or viewer is not above the surface.
nacre_PhysicalTerms nacre_physicalTerms(nacre_Material m, nacre_PhysicalView w, vec3 l)
{
    nacre_PhysicalTerms t = nacre_PhysicalTerms(0.0, vec3(0.0), 1.0, vec3(0.0), vec3(0.0), vec3(0.0));
    nacre_View o = w.layer;
    float cosTheta = min(dot(o.upperNormal, l), 1.0);
    if (cosTheta > 0.0 && o.cosTheta > 0.0) {
        vec3 halfVector = l + o.direction;
        t.cosHalfSquared = min(0.25 * dot(halfVector, halfVector), 1.0);
        // Below the outside's index the reflectance leaps to 1 at the critical angle. A half vector beyond it,
        // light or viewer on this side, would reflect what has entered already (albedo 1.24 at index 0.5): the
        // steepest of the three angles reflects the least of them.
        float steepest = max(cosTheta, o.cosTheta);
        bool isBelow = any(lessThan(m.oneMinusEtaSquared, vec3(0.0)));
        t.cosHalfSquared = isBelow ? max(t.cosHalfSquared, steepest * steepest) : t.cosHalfSquared;
        vec3 cosSquared = nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta);
        vec3 cosRefracted = sqrt(max(cosSquared, 0.0));
        float upper = nacre_upperLobeOneMinus(o.upperNormal, halfVector, cosTheta, o.cosTheta);

        vec3 lower;
#if NACRE_TILT == 0
        vec3 across = halfVector - o.upperNormal * (cosTheta + o.cosTheta);
        lower = nacre_lowerLobeOneMinusParallel(m.etaSquared, dot(across, across), cosTheta, o.cosTheta, cosRefracted + o.cosRefracted);
        bvec3 meets = lessThan(lower, vec3(1.0));
#else
        vec3 lowerCosine = nacre_lowerCosine(m.eta, o.cosBetween, cosTheta, dot(o.lowerNormal, l), cosRefracted);
        vec2 halfAcross = vec2(dot(o.frameX, halfVector), dot(o.frameY, halfVector));
        lower = nacre_lowerLobeOneMinus(m.eta, halfAcross, o.upperAcross, cosTheta + o.cosTheta,
                                        cosRefracted + o.cosRefracted, lowerCosine - o.lowerCosine);
        // The three null conditions under Eq 10.
        vec3 worst = max(lower - 1.0, max(lowerCosine, o.lowerCosine));
        bvec3 meets = lessThan(worst, vec3(0.0));
#endif
        t.rootUpper = nacre_powerOneMinus(upper, 0.5 * m.upperExponent);
        t.rootLower = mix(vec3(0.0), nacre_powerOneMinus(lower, 0.5 * m.lowerExponent), meets);
        if (m.lobes == 1) {
            t.rootUpper *= m.upperScale * inversesqrt(nacre_lobeFlattening(m.upperExponent, max(cosTheta, o.cosTheta)));
            t.rootLower *= w.lowerScale *
                           inversesqrt(max(nacre_lobeFlattening(m.lowerExponent, max(cosRefracted, o.cosRefracted)), 1e-18));
        }

        // 0 beyond the critical angle, where no ray enters or leaves.
        nacre_crossings(m.eta, cosTheta, cosRefracted, t.crossingS, t.crossingP);
        t.crossingS *= w.crossingS;
        t.crossingP *= w.crossingP;
        t.path = w.pathAtNormal * (cosRefracted + o.cosRefracted);
    }
    return t;
}

#endif
