#ifndef NACRE_PHYSICAL_LIGHT_GLSL
#define NACRE_PHYSICAL_LIGHT_GLSL

// Quality `physical`, second half: what a light adds to the view of nacre_physical.glsl, the film of
// nacre_airy.glsl between the two lobes in three channels.

// The film of one channel. crossing: tau of s and p. The angle within the film is that of the half vector's,
// refracted: light and viewer enter alike, and in the mirror direction it is the ray's own.
// Below the outside's index, beyond the critical angle: a^2 = 1, and nothing else.
nacre_Film nacre_filmOf(float eta, float oneMinusEtaSquared, vec2 substrate, int kind, float cosHalfSquared, vec2 crossing)
{
    float cosSquared = oneMinusEtaSquared + eta * eta * cosHalfSquared;
    float sineSquared = eta * eta * (1.0 - cosHalfSquared);
    float cosRefracted = sqrt(max(cosSquared, 0.0));
    vec2 a = nacre_upperAmplitudes(eta, oneMinusEtaSquared, sqrt(cosHalfSquared), cosRefracted);
    bool reflectsAll = cosSquared < 0.0;
    a = reflectsAll ? vec2(1.0) : a;
    crossing = reflectsAll ? vec2(0.0) : crossing;
    if (kind == NACRE_SUBSTRATE_METAL) {
        vec4 b = nacre_lowerAmplitudesMetal(substrate, sineSquared, cosRefracted);
        return nacre_film(a, vec2(dot(b.xy, b.xy), dot(b.zw, b.zw)), -a.xxyy * b, crossing);
    }
    vec2 b = nacre_lowerAmplitudes(substrate.x, sineSquared, cosRefracted);
    vec2 q = -a * b;
    return nacre_film(a, b * b, vec4(q.x, 0.0, q.y, 0.0), crossing);
}

// rho of one channel; cosine, sine: that channel's fringes, sine for metals alone.
float nacre_filmChannel(nacre_Film film, int kind, float cosine[NACRE_ORDERS], float sine[NACRE_ORDERS], float coherence,
                        float rootUpper, float rootLower)
{
    float fringes;
    if (kind == NACRE_SUBSTRATE_METAL) {
        vec2 c[NACRE_ORDERS];
        for (int m = 0; m < NACRE_ORDERS; ++m) c[m] = vec2(cosine[m], sine[m]);
        fringes = nacre_fringeSumMetal(film, c, coherence);
    } else {
        fringes = nacre_fringeSum(film, cosine, coherence);
    }
    return nacre_filmReflectance(film, fringes, rootUpper, rootLower);
}

// The film in three channels: the specular part rho, a BRDF without the cosine.
vec3 nacre_filmSpecular(nacre_Material m, nacre_PhysicalTerms t, nacre_Fringe cosine, nacre_Fringe sine)
{
    vec3 rho;
    for (int channel = 0; channel < 3; ++channel) {
        nacre_Film film = nacre_filmOf(m.eta[channel], m.oneMinusEtaSquared[channel],
                                       vec2(m.substrateReal[channel], m.substrateImaginary[channel]), m.substrate,
                                       t.cosHalfSquared, vec2(t.crossingS[channel], t.crossingP[channel]));
        float c[NACRE_ORDERS], s[NACRE_ORDERS];
        for (int order = 0; order < NACRE_ORDERS; ++order) {
            c[order] = cosine.order[order][channel];
            s[order] = sine.order[order][channel];
        }
        rho[channel] = nacre_filmChannel(film, m.substrate, c, s, cosine.coherence[channel], t.rootUpper, t.rootLower[channel]);
    }
    return rho;
}

// The specular part rho, a BRDF without the cosine.
vec3 nacre_physicalSpecular(nacre_Material m, nacre_PhysicalView w, vec3 l)
{
    nacre_PhysicalTerms t = nacre_physicalTerms(m, w, l);
    nacre_Fringe cosine = nacre_cosineFringe(t.path);
    nacre_Fringe sine = cosine;
    if (m.substrate == NACRE_SUBSTRATE_METAL) sine = nacre_sineFringe(t.path);
    return nacre_filmSpecular(m, t, cosine, sine);
}

vec3 nacre_physicalSpecular(nacre_Material m, nacre_PhysicalView w, vec3 l, sampler2D fringeTable)
{
    nacre_PhysicalTerms t = nacre_physicalTerms(m, w, l);
    nacre_Fringe cosine = nacre_cosineFringe(fringeTable, t.path);
    nacre_Fringe sine = cosine;
    if (m.substrate == NACRE_SUBSTRATE_METAL) sine = nacre_sineFringe(fringeTable, t.path);
    return nacre_filmSpecular(m, t, cosine, sine);
}

// What a light of radiance 1 adds to the pixel: both parts, weighted as in Sec 6, times the cosine.
vec3 nacre_physicalWeighted(nacre_Material m, nacre_PhysicalView w, vec3 l, vec3 specular)
{
    float cosTheta = w.layer.cosTheta > 0.0 ? clamp(dot(w.layer.upperNormal, l), 0.0, 1.0) : 0.0;
    return (m.specularWeight * specular + m.diffuseWeight * w.diffuse) * cosTheta;
}

vec3 nacre_physicalLight(nacre_Material m, nacre_PhysicalView w, vec3 l)
{
    return nacre_physicalWeighted(m, w, l, nacre_physicalSpecular(m, w, l));
}

vec3 nacre_physicalLight(nacre_Material m, nacre_PhysicalView w, vec3 l, sampler2D fringeTable)
{
    return nacre_physicalWeighted(m, w, l, nacre_physicalSpecular(m, w, l, fringeTable));
}

#endif
