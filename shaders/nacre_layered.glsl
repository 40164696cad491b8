#ifndef NACRE_LAYERED_GLSL
#define NACRE_LAYERED_GLSL

// The layered material at a point: Granier & Heidrich 2003, Sec 4 and 5, put together from the other
// files. What the viewer sees is computed once (nacre_view), then each light asks for its share.

// What depends on material, surface and view, not on the light.
struct nacre_View {
    vec3 direction;           // to the viewer, unit [o]
    vec3 upperNormal;         // unit [n0]
    float cosTheta;           // <n0, v>; 0 where nothing is seen, a normal without direction included
#if NACRE_SPECULAR
    nacre_Channels cosRefracted;  // cosTo: <-t_o, n0>
#endif
#if NACRE_SPECULAR && NACRE_TILT
    vec3 lowerNormal;         // unit [n1]
    float cosBetween;         // <n0, n1>
    vec3 frameX;              // with frameY and lowerNormal a right-handed frame
    vec3 frameY;
    vec2 upperAcross;         // n0 in the plane across n1
    nacre_Channels lowerCosine;   // <t_o, n1>
#endif
#if NACRE_SPECULAR && NACRE_PAPER
    nacre_Channels sqrtTransmittance;  // root of the transmittance out of the layer, Eq 9, and of the part of that into it
                                       // which no angle changes, 1 - f; 0: no way out
    nacre_Path path;          // r1 d / lambda
#endif
    vec3 diffuse;             // rho_d, Eq 16, times its weight
};

#if NACRE_SPECULAR

// What light and view make of each other, before they interfere.
struct nacre_Terms {
    nacre_Channels sqrtR;  // root of the upper boundary's reflection [R, Eq 6]
    nacre_Channels sqrtT;  // root of the part that went through the layer [T, Eq 10]
    vec3 cycles;  // path through the layer in wavelengths but for whole ones [Phi / pi, Eq 3]; means nothing where sqrtT is 0
    float upperOneMinus;           // 1 - the lobe's cosine at the upper boundary, Eq 6
    nacre_Channels lowerOneMinus;  // 1 - the lobe's cosine at the lower boundary, Eq 10
};

// The lower boundary as the viewer sees it: normal, frame, the viewer's ray.
void nacre_viewThroughLayer(nacre_Material m, nacre_Surface s, inout nacre_View w)
{
    w.cosRefracted = nacre_refractedCosine(nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, w.cosTheta));
#if NACRE_TILT
    w.lowerNormal = nacre_direction(s.lowerNormal);
    if (!(dot(w.lowerNormal, w.lowerNormal) > 0.0)) w.cosTheta = 0.0;
    w.cosBetween = dot(w.upperNormal, w.lowerNormal);
    nacre_frame(w.lowerNormal, w.frameX, w.frameY);
    w.upperAcross = vec2(dot(w.upperNormal, w.frameX), dot(w.upperNormal, w.frameY));
    w.lowerCosine = nacre_lowerCosine(m.eta, w.cosBetween, w.cosTheta, dot(w.lowerNormal, w.direction), w.cosRefracted);
#endif
}

#if NACRE_PAPER

// 0 where the viewer's ray leaves the layer on the far side or not at all.
nacre_Channels nacre_sqrtTransmittanceOut(nacre_Material m, nacre_View w)
{
    nacre_Channels root = (1.0 - m.normalReflectance) * sqrt(max(nacre_transmittanceShape(w.cosRefracted), 0.0));
#if NACRE_TILT
    return mix(nacre_Channels(0.0), root, nacre_less(w.lowerCosine, nacre_Channels(0.0)));
#else
    return root;
#endif
}

#endif
#endif

#if NACRE_PAPER && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
nacre_Path nacre_pathOf(nacre_Material m, nacre_Surface s)
{
    return nacre_path(m.cyclesPerUm, m.cyclesPerUmTail, s.thicknessUm);
}
#endif

// The part that both qualities share; v: unit vector to the viewer.
nacre_View nacre_viewOfSurface(nacre_Material m, nacre_Surface s, vec3 v)
{
    nacre_View w;
    w.direction = v;
    w.upperNormal = nacre_direction(s.upperNormal);
    float cosTheta = dot(w.upperNormal, v);
    w.cosTheta = cosTheta > 0.0 ? min(cosTheta, 1.0) : 0.0;  // a normal without direction is the zero vector
#if NACRE_SPECULAR
    nacre_viewThroughLayer(m, s, w);
#endif
    w.diffuse = vec3(0.0);
    return w;
}

#if NACRE_PAPER

// v: unit vector to the viewer.
nacre_View nacre_view(nacre_Material m, nacre_Surface s, vec3 v)
{
    nacre_View w = nacre_viewOfSurface(m, s, v);
#if NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
    nacre_Path path = nacre_pathOf(m, s);
#elif NACRE_SPECULAR
    nacre_Path path = nacre_constantPath(m.pathHead, m.pathTail);
#endif
#if NACRE_SPECULAR
    w.sqrtTransmittance = nacre_sqrtTransmittanceOut(m, w);
    w.path = path;
#endif
#if NACRE_DIFFUSE && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    w.diffuse = w.cosTheta > 0.0 ? m.diffuse : vec3(0.0);
#elif NACRE_DIFFUSE
    vec3 cosPhase = nacre_cosPhase(nacre_pathCycles(path, nacre_Channels(2.0)));
    w.diffuse = w.cosTheta > 0.0 ? m.diffuseWeight * nacre_diffuseCoefficient(m.diffuseFringe, cosPhase) : vec3(0.0);
#endif
    return w;
}

#if NACRE_SPECULAR

// l: unit vector to the light. All zero where light or viewer is not above the surface.
nacre_Terms nacre_terms(nacre_Material m, nacre_View w, vec3 l)
{
    nacre_Channels none = nacre_Channels(0.0);
    nacre_Terms t = nacre_Terms(none, none, vec3(0.0), 1.0, nacre_Channels(1.0));
    float cosTheta = min(dot(w.upperNormal, l), 1.0);
    if (cosTheta > 0.0 && w.cosTheta > 0.0) {
        vec3 halfVector = l + w.direction;
        nacre_Channels cosSquared = nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta);
        nacre_Channels cosRefracted = nacre_refractedCosine(cosSquared);

        t.upperOneMinus = nacre_upperLobeOneMinus(w.upperNormal, halfVector, cosTheta, w.cosTheta);
        nacre_Channels reflectance = nacre_reflectance(m.normalReflectance, cosTheta);
#if NACRE_TOTAL_REFLECTION
        nacre_ChannelsTest reflectsAll = nacre_less(cosSquared, none);
        reflectance = mix(reflectance, nacre_Channels(1.0), reflectsAll);
#endif
        t.sqrtR = sqrt(reflectance) * nacre_powerOneMinus(t.upperOneMinus, 0.5 * m.upperExponent);

        // The three null conditions under Eq 10, of which the viewer's is in w.sqrtTransmittance: the light's ray, the lobe.
#if NACRE_TILT
        nacre_Channels lowerCosine = nacre_lowerCosine(m.eta, w.cosBetween, cosTheta, dot(w.lowerNormal, l), cosRefracted);
        vec2 halfAcross = vec2(dot(w.frameX, halfVector), dot(w.frameY, halfVector));
        t.lowerOneMinus = nacre_lowerLobeOneMinus(m.eta, halfAcross, w.upperAcross, cosTheta + w.cosTheta,
                                                  cosRefracted + w.cosRefracted, lowerCosine - w.lowerCosine);
#else
        t.lowerOneMinus = nacre_lowerLobeOneMinus(m.etaSquared, w.upperNormal, halfVector, cosTheta, w.cosTheta,
                                                  cosRefracted, w.cosRefracted);
#endif
        t.sqrtT = sqrt(nacre_transmittanceShape(cosTheta)) * w.sqrtTransmittance * nacre_powerOneMinus(t.lowerOneMinus, 0.5 * m.lowerExponent);
#if NACRE_STABLE_LOBES
        t.sqrtT = mix(none, t.sqrtT, nacre_less(t.lowerOneMinus, nacre_Channels(1.0)));  // an exponent of 0 has 0^0
#endif
#if NACRE_TILT
        t.sqrtT = mix(none, t.sqrtT, nacre_less(lowerCosine, none));
#endif
#if NACRE_TOTAL_REFLECTION
        t.sqrtT = mix(t.sqrtT, none, reflectsAll);
#endif

        t.cycles = nacre_pathCycles(w.path, cosRefracted + w.cosRefracted);
    }
    return t;
}

// The specular part rho, a BRDF without the cosine: Eq 5.
vec3 nacre_specular(nacre_Material m, nacre_View w, vec3 l)
{
    nacre_Terms t = nacre_terms(m, w, l);
    return nacre_interference(t.sqrtR, t.sqrtT, nacre_cosPhase(t.cycles));
}

#endif

// What a light of radiance 1 adds to the pixel: both parts, weighted as in Sec 6, times the cosine.
// Where the light does not reach, nothing is computed.
vec3 nacre_light(nacre_Material m, nacre_View w, vec3 l)
{
#if NACRE_SPECULAR
    float cosTheta = min(dot(w.upperNormal, l), 1.0);
    if (!(cosTheta > 0.0 && w.cosTheta > 0.0)) return vec3(0.0);
    return (w.diffuse + m.specularWeight * nacre_specular(m, w, l)) * cosTheta;
#else
    return w.diffuse * clamp(dot(w.upperNormal, l), 0.0, 1.0);
#endif
}

#endif

#endif
