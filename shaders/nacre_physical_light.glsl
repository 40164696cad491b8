#ifndef NACRE_PHYSICAL_LIGHT_GLSL
#define NACRE_PHYSICAL_LIGHT_GLSL

// Quality `physical`, second half: what a light adds to the view of nacre_physical.glsl, the film of
// nacre_airy.glsl between the two lobes in three channels.

#if NACRE_PHYSICAL && NACRE_SPECULAR

// The film of one channel. The angle within the film is that of the half vector's,
// refracted: light and viewer enter alike, and in the mirror direction it is the ray's own.
// Below the outside's index, beyond the critical angle: a^2 = 1, and nothing else.
nacre_Film nacre_filmOf(nacre_Material m, nacre_PhysicalTerms t, int channel)
{
    float eta = nacre_channel(m.eta, channel);
    float etaSquared = nacre_channel(m.etaSquared, channel);
    float oneMinusEtaSquared = nacre_channel(m.oneMinusEtaSquared, channel);
    vec2 crossing = vec2(nacre_channel(t.crossingS, channel), nacre_channel(t.crossingP, channel));

    float cosSquared = oneMinusEtaSquared + etaSquared * t.cosHalfSquared;
    float sineSquared = etaSquared * (1.0 - t.cosHalfSquared);
    float cosRefracted = sqrt(max(cosSquared, 0.0));
    vec2 a = nacre_upperAmplitudes(eta, oneMinusEtaSquared, sqrt(t.cosHalfSquared), cosRefracted);
#if NACRE_TOTAL_REFLECTION
    bool reflectsAll = cosSquared < 0.0;
    a = reflectsAll ? vec2(1.0) : a;
    crossing = reflectsAll ? vec2(0.0) : crossing;
#endif
    nacre_Film film;
#if NACRE_METAL
    vec4 b = nacre_lowerAmplitudesMetal(vec2(m.substrateReal[channel], m.substrateImaginary[channel]), sineSquared, cosRefracted);
    film.ratio = -a.xxyy * b;
    nacre_weigh(film, a * a, vec2(dot(b.xy, b.xy), dot(b.zw, b.zw)), crossing);
#else
    vec2 b = nacre_lowerAmplitudes(m.substrateReal[channel], sineSquared, cosRefracted);
    film.ratio = -a * b;
    nacre_weigh(film, a * a, b * b, crossing);
#endif
    return film;
}

#if NACRE_FRINGE_TABLE

// The film of one channel in the three of the fringes: where all channels have the same film, it is theirs.
vec3 nacre_filmSpecular(nacre_Material m, nacre_PhysicalView w, nacre_PhysicalTerms t, int channel, sampler2D fringeTable)
{
    nacre_Film film = nacre_filmOf(m, t, channel);
    highp float pathPerRadian = 0.0;
#if NACRE_METAL
    pathPerRadian = w.pathPerRadian[channel];
#endif
    vec3 fringes = nacre_fringeSum(fringeTable, film, nacre_channel(t.path, channel), pathPerRadian);
    return nacre_filmReflectance(film, fringes, t.rootUpper, nacre_channel(t.rootLower, channel));
}

// The specular part rho, a BRDF without the cosine.
vec3 nacre_physicalSpecular(nacre_Material m, nacre_PhysicalView w, vec3 l, sampler2D fringeTable)
{
    nacre_PhysicalTerms t = nacre_physicalTerms(m, w, l);
#if NACRE_SUBSTRATE_CHANNELS
    return vec3(nacre_filmSpecular(m, w, t, 0, fringeTable).x, nacre_filmSpecular(m, w, t, 1, fringeTable).y,
                nacre_filmSpecular(m, w, t, 2, fringeTable).z);
#else
    return nacre_filmSpecular(m, w, t, 0, fringeTable);
#endif
}

#endif

#if NACRE_SAMPLER_FREE

// The same without a table.
vec3 nacre_filmSpecular(nacre_Material m, nacre_PhysicalView w, nacre_PhysicalTerms t, int channel)
{
    nacre_Film film = nacre_filmOf(m, t, channel);
    highp float path = nacre_channel(t.path, channel);
    nacre_Fringe cosine = nacre_cosineFringe(path);
    vec3 fringes;
#if NACRE_METAL
    if (m.substrate == NACRE_SUBSTRATE_METAL) fringes = vec3(nacre_fringeSumMetal(film, cosine, nacre_sineFringe(path), channel));
    else fringes = nacre_fringeSum(film, cosine);
#else
    fringes = nacre_fringeSum(film, cosine);
#endif
    return nacre_filmReflectance(film, fringes, t.rootUpper, nacre_channel(t.rootLower, channel));
}

vec3 nacre_physicalSpecular(nacre_Material m, nacre_PhysicalView w, vec3 l)
{
    nacre_PhysicalTerms t = nacre_physicalTerms(m, w, l);
#if NACRE_SUBSTRATE_CHANNELS
    return vec3(nacre_filmSpecular(m, w, t, 0).x, nacre_filmSpecular(m, w, t, 1).y, nacre_filmSpecular(m, w, t, 2).z);
#else
    return nacre_filmSpecular(m, w, t, 0);
#endif
}

#endif

#endif

#if NACRE_PHYSICAL

// What a light of radiance 1 adds to the pixel: both parts, weighted as in Sec 6, times the cosine.
// Where the light does not reach, nothing is computed.

#if NACRE_SAMPLER_FREE
vec3 nacre_physicalLight(nacre_Material m, nacre_PhysicalView w, vec3 l)
{
#if NACRE_SPECULAR
    float cosTheta = min(dot(w.layer.upperNormal, l), 1.0);
    if (!(cosTheta > 0.0 && w.layer.cosTheta > 0.0)) return vec3(0.0);
    return (w.diffuse + m.specularWeight * nacre_physicalSpecular(m, w, l)) * cosTheta;
#else
    return w.diffuse * clamp(dot(w.layer.upperNormal, l), 0.0, 1.0);
#endif
}
#endif

#if NACRE_FRINGE_TABLE
vec3 nacre_physicalLight(nacre_Material m, nacre_PhysicalView w, vec3 l, sampler2D fringeTable)
{
#if NACRE_SPECULAR
    float cosTheta = min(dot(w.layer.upperNormal, l), 1.0);
    if (!(cosTheta > 0.0 && w.layer.cosTheta > 0.0)) return vec3(0.0);
    return (w.diffuse + m.specularWeight * nacre_physicalSpecular(m, w, l, fringeTable)) * cosTheta;
#else
    return w.diffuse * clamp(dot(w.layer.upperNormal, l), 0.0, 1.0);
#endif
}
#endif

#endif

#endif
