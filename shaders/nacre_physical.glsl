#ifndef NACRE_PHYSICAL_GLSL
#define NACRE_PHYSICAL_GLSL

// Quality `physical`: the paper's two lobes with a real film between them (nacre_physical_light.glsl). As in
// nacre_layered.glsl the view is computed once, then each light asks for its share. Light and viewer
// may be swapped. Every function that needs fringes has two forms: with the fringe table, or without.

#if NACRE_PHYSICAL

// What depends on material, surface and view, not on the light.
struct nacre_PhysicalView {
    nacre_View layer;                     // what both qualities share
#if NACRE_SPECULAR
    nacre_Channels crossingS, crossingP;  // root of what leaves the layer towards the viewer, per polarisation
    highp nacre_Channels pathAtNormal;    // r1 d, um
#endif
#if NACRE_SPECULAR && NACRE_NORMALISED
    nacre_Channels lowerScale;            // root of what normalises the lower lobe
#endif
#if NACRE_SPECULAR && NACRE_METAL && NACRE_FRINGE_TABLE
    vec3 pathPerRadian;                   // lambda / 2pi, um
#endif
    vec3 diffuse;                         // BRDF of the diffuse part, times its weight
};

#if NACRE_SPECULAR

// What light and view make of each other, before they interfere.
struct nacre_PhysicalTerms {
    float rootUpper;                      // sqrt L0
    nacre_Channels rootLower;             // sqrt L1
    float cosHalfSquared;                 // of the angle between light and half vector
    nacre_Channels crossingS, crossingP;  // tau: into the layer and out of it
    highp nacre_Channels path;            // r1 d (cosTi + cosTo), um
};

// tau of one direction.
void nacre_crossings(nacre_Channels eta, float cosTheta, nacre_Channels cosRefracted, out nacre_Channels s, out nacre_Channels p)
{
#if NACRE_DISPERSION
    vec2 r = nacre_crossing(eta.x, cosTheta, cosRefracted.x);
    vec2 g = nacre_crossing(eta.y, cosTheta, cosRefracted.y);
    vec2 b = nacre_crossing(eta.z, cosTheta, cosRefracted.z);
    s = vec3(r.x, g.x, b.x);
    p = vec3(r.y, g.y, b.y);
#else
    vec2 both = nacre_crossing(eta, cosTheta, cosRefracted);
    s = both.x;
    p = both.y;
#endif
}

#endif

// The view but for its diffuse part. v: unit vector to the viewer.
nacre_PhysicalView nacre_physicalViewWithoutDiffuse(nacre_Material m, nacre_Surface s, vec3 v)
{
    nacre_PhysicalView w;
    w.layer = nacre_viewOfSurface(m, s, v);
    w.diffuse = vec3(0.0);
#if NACRE_SPECULAR
    nacre_crossings(m.eta, w.layer.cosTheta, w.layer.cosRefracted, w.crossingS, w.crossingP);
#if NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    w.pathAtNormal = m.index * m.thicknessUm;
#else
    w.pathAtNormal = m.index * nacre_sound(s.thicknessUm);
#endif
#if NACRE_METAL && NACRE_FRINGE_TABLE
    w.pathPerRadian = 0.159154943 * vec3(m.index) / m.cyclesPerUm;
#endif
#if NACRE_NORMALISED
    w.lowerScale = nacre_Channels(1.0);
    float sineOfTilt = 0.0;
#if NACRE_TILT
    sineOfTilt = length(w.layer.upperAcross);
#endif
    if (m.lobes == 1) w.lowerScale = m.lowerScale * nacre_lowerLobeScale(m.eta, sineOfTilt, m.lowerExponent);
#endif
#endif
    return w;
}

#if NACRE_DIFFUSE && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT

// Diffuse BRDF: Eq 16 with the sensor's fringe in place of one wavelength's, over its greatest value
// (sqrt Rd + sqrt Td)^2, so that it never exceeds the albedo, over pi. cosine: C(2 r1 d).
vec3 nacre_physicalDiffuse(nacre_Material m, vec3 cosine)
{
    vec3 fringe = (1.0 + m.diffuseFringe * clamp(cosine, -1.0, 1.0)) / (1.0 + m.diffuseFringe);
    return m.diffuseAlbedo * fringe * (0.318309886 * m.diffuseWeight);
}

#endif

#if NACRE_SAMPLER_FREE
nacre_PhysicalView nacre_physicalView(nacre_Material m, nacre_Surface s, vec3 v)
{
    nacre_PhysicalView w = nacre_physicalViewWithoutDiffuse(m, s, v);
#if NACRE_DIFFUSE && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    if (w.layer.cosTheta > 0.0) w.diffuse = m.diffuse;
#elif NACRE_DIFFUSE
    if (w.layer.cosTheta > 0.0) w.diffuse = nacre_physicalDiffuse(m, nacre_firstFringe(2.0 * m.index * nacre_sound(s.thicknessUm)));
#endif
    return w;
}
#endif

#if NACRE_FRINGE_TABLE
nacre_PhysicalView nacre_physicalView(nacre_Material m, nacre_Surface s, vec3 v, sampler2D fringeTable)
{
    nacre_PhysicalView w = nacre_physicalViewWithoutDiffuse(m, s, v);
#if NACRE_DIFFUSE && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    if (w.layer.cosTheta > 0.0) w.diffuse = m.diffuse;
#elif NACRE_DIFFUSE
    if (w.layer.cosTheta > 0.0) w.diffuse = nacre_physicalDiffuse(m, nacre_firstFringe(fringeTable, 2.0 * m.index * nacre_sound(s.thicknessUm)));
#endif
    return w;
}
#endif

#if NACRE_SPECULAR

// l: unit vector to the light. No lobes where light or viewer is not above the surface.
nacre_PhysicalTerms nacre_physicalTerms(nacre_Material m, nacre_PhysicalView w, vec3 l)
{
    nacre_Channels none = nacre_Channels(0.0);
    nacre_PhysicalTerms t = nacre_PhysicalTerms(0.0, none, 1.0, none, none, none);
    nacre_View o = w.layer;
    float cosTheta = min(dot(o.upperNormal, l), 1.0);
    if (cosTheta > 0.0 && o.cosTheta > 0.0) {
        vec3 halfVector = l + o.direction;
        t.cosHalfSquared = min(0.25 * dot(halfVector, halfVector), 1.0);
#if NACRE_TOTAL_REFLECTION
        // Below the outside's index the reflectance leaps to 1 at the critical angle. A half vector beyond it,
        // light or viewer on this side, would reflect what has entered already (albedo 1.24 at index 0.5): the
        // steepest of the three angles reflects the least of them.
        float steepest = max(cosTheta, o.cosTheta);
        bool isBelow = nacre_any(nacre_less(m.oneMinusEtaSquared, none));
        t.cosHalfSquared = isBelow ? max(t.cosHalfSquared, steepest * steepest) : t.cosHalfSquared;
#endif
        nacre_Channels cosRefracted = nacre_refractedCosine(nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta));
        float upper = nacre_upperLobeOneMinus(o.upperNormal, halfVector, cosTheta, o.cosTheta);

#if NACRE_TILT
        nacre_Channels lowerCosine = nacre_lowerCosine(m.eta, o.cosBetween, cosTheta, dot(o.lowerNormal, l), cosRefracted);
        vec2 halfAcross = vec2(dot(o.frameX, halfVector), dot(o.frameY, halfVector));
        nacre_Channels lower = nacre_lowerLobeOneMinus(m.eta, halfAcross, o.upperAcross, cosTheta + o.cosTheta,
                                                       cosRefracted + o.cosRefracted, lowerCosine - o.lowerCosine);
#else
        nacre_Channels lower = nacre_lowerLobeOneMinus(m.etaSquared, o.upperNormal, halfVector, cosTheta, o.cosTheta,
                                                       cosRefracted, o.cosRefracted);
#endif
        t.rootUpper = nacre_powerOneMinus(upper, 0.5 * m.upperExponent);
        t.rootLower = nacre_powerOneMinus(lower, 0.5 * m.lowerExponent);
        // The three null conditions under Eq 10.
#if NACRE_STABLE_LOBES
        t.rootLower = mix(none, t.rootLower, nacre_less(lower, nacre_Channels(1.0)));  // an exponent of 0 has 0^0
#endif
#if NACRE_TILT
        t.rootLower = mix(none, t.rootLower, nacre_less(max(lowerCosine, o.lowerCosine), none));
#endif
#if NACRE_NORMALISED
        if (m.lobes == 1) {
            t.rootUpper *= m.upperScale * inversesqrt(nacre_lobeFlattening(m.upperExponent, max(cosTheta, o.cosTheta)));
            t.rootLower *= w.lowerScale *
                           inversesqrt(max(nacre_lobeFlattening(m.lowerExponent, max(cosRefracted, o.cosRefracted)), 1e-18));
        }
#endif

        // 0 beyond the critical angle, where no ray enters or leaves.
        nacre_crossings(m.eta, cosTheta, cosRefracted, t.crossingS, t.crossingP);
        t.crossingS *= w.crossingS;
        t.crossingP *= w.crossingP;
        t.path = w.pathAtNormal * (cosRefracted + o.cosRefracted);
    }
    return t;
}

#endif

#endif

#endif
