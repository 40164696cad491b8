#ifndef NACRE_LAYERED_GLSL
#define NACRE_LAYERED_GLSL

// The layered material at a point: Granier & Heidrich 2003, Sec 4 and 5, put together from the other
// files. What the viewer sees is computed once (nacre_view), then each light asks for its share.

// What depends on material, surface and view, not on the light.
struct nacre_View {
    vec3 direction;           // to the viewer, unit [o]
    vec3 upperNormal;         // unit [n0]
    vec3 lowerNormal;         // unit [n1]
    float cosTheta;           // <n0, v>; 0 where nothing is seen, a normal without direction included
    float cosBetween;         // <n0, n1>
    vec3 frameX;              // with frameY and lowerNormal a right-handed frame
    vec3 frameY;
    vec2 upperAcross;         // n0 in the plane across n1
    vec3 cosRefracted;        // cosTo: <-t_o, n0> per channel
    vec3 lowerCosine;         // <t_o, n1>
    vec3 sqrtTransmittance;   // root of the transmittance out of the layer, Eq 9; 0: no way out
    nacre_Path path;          // r1 d / lambda
    vec3 diffuse;             // rho_d, Eq 16
};

// What light and view make of each other, before they interfere.
struct nacre_Terms {
    vec3 sqrtR;   // root of the upper boundary's reflection [R, Eq 6]
    vec3 sqrtT;   // root of the part that went through the layer [T, Eq 10]
    vec3 cycles;  // path through the layer in wavelengths but for whole ones [Phi / pi, Eq 3]; means nothing where sqrtT is 0
    float upperOneMinus;  // 1 - the lobe's cosine at the upper boundary, Eq 6
    vec3 lowerOneMinus;   // 1 - the lobe's cosine at the lower boundary, Eq 10
};

// v: unit vector to the viewer.
nacre_View nacre_view(nacre_Material m, nacre_Surface s, vec3 v)
{
    nacre_View w;
    w.direction = v;
    w.upperNormal = nacre_direction(s.upperNormal);
    w.lowerNormal = nacre_direction(s.lowerNormal);
    bool hasNormals = dot(w.upperNormal, w.upperNormal) > 0.0 && dot(w.lowerNormal, w.lowerNormal) > 0.0;
    float cosTheta = dot(w.upperNormal, v);
    w.cosTheta = hasNormals && cosTheta > 0.0 ? min(cosTheta, 1.0) : 0.0;
    w.cosBetween = dot(w.upperNormal, w.lowerNormal);
    nacre_frame(w.lowerNormal, w.frameX, w.frameY);
    w.upperAcross = vec2(dot(w.upperNormal, w.frameX), dot(w.upperNormal, w.frameY));

    vec3 cosSquared = nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, w.cosTheta);
    w.cosRefracted = sqrt(max(cosSquared, 0.0));
    w.lowerCosine = nacre_lowerCosine(m.eta, w.cosBetween, w.cosTheta, dot(w.lowerNormal, v), w.cosRefracted);
    vec3 transmittance = (1.0 - m.normalReflectance) * nacre_transmittanceShape(w.cosRefracted);
    bvec3 leaves = lessThan(w.lowerCosine, vec3(0.0));
    w.sqrtTransmittance = mix(vec3(0.0), sqrt(max(transmittance, 0.0)), leaves);

    w.path = nacre_path(m.cyclesPerUm, m.cyclesPerUmTail, s.thicknessUm);
    vec3 cosPhase = nacre_cosPhase(nacre_pathCycles(w.path, vec3(2.0)));
    w.diffuse = hasNormals ? nacre_diffuseCoefficient(m.diffuseFringe, cosPhase) : vec3(0.0);
    return w;
}

// l: unit vector to the light. All zero where light or viewer is not above the surface.
nacre_Terms nacre_terms(nacre_Material m, nacre_View w, vec3 l)
{
    nacre_Terms t = nacre_Terms(vec3(0.0), vec3(0.0), vec3(0.0), 1.0, vec3(1.0));
    float cosTheta = min(dot(w.upperNormal, l), 1.0);
    if (cosTheta > 0.0 && w.cosTheta > 0.0) {
        vec3 halfVector = l + w.direction;

        vec3 cosSquared = nacre_refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosTheta);
        bvec3 reflectsAll = lessThan(cosSquared, vec3(0.0));
        vec3 cosRefracted = sqrt(max(cosSquared, 0.0));

        t.upperOneMinus = nacre_upperLobeOneMinus(w.upperNormal, halfVector, cosTheta, w.cosTheta);
        vec3 reflectance = mix(nacre_reflectance(m.normalReflectance, cosTheta), vec3(1.0), reflectsAll);
        t.sqrtR = sqrt(reflectance) * nacre_powerOneMinus(t.upperOneMinus, 0.5 * m.upperExponent);

        vec3 lowerCosine = nacre_lowerCosine(m.eta, w.cosBetween, cosTheta, dot(w.lowerNormal, l), cosRefracted);
        vec2 halfAcross = vec2(dot(w.frameX, halfVector), dot(w.frameY, halfVector));
        t.lowerOneMinus = nacre_lowerLobeOneMinus(m.eta, halfAcross, w.upperAcross, cosTheta + w.cosTheta,
                                                  cosRefracted + w.cosRefracted, lowerCosine - w.lowerCosine);
        vec3 transmittance = (1.0 - m.normalReflectance) * nacre_transmittanceShape(cosTheta);
        vec3 sqrtT = sqrt(transmittance) * w.sqrtTransmittance * nacre_powerOneMinus(t.lowerOneMinus, 0.5 * m.lowerExponent);
        // The three null conditions under Eq 10; the viewer's is in w.sqrtTransmittance.
        sqrtT = mix(vec3(0.0), sqrtT, lessThan(lowerCosine, vec3(0.0)));
        sqrtT = mix(vec3(0.0), sqrtT, lessThan(t.lowerOneMinus, vec3(1.0)));
        t.sqrtT = mix(sqrtT, vec3(0.0), reflectsAll);

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

// What a light of radiance 1 adds to the pixel: both parts, weighted as in Sec 6, times the cosine.
vec3 nacre_light(nacre_Material m, nacre_View w, vec3 l)
{
    float cosTheta = w.cosTheta > 0.0 ? clamp(dot(w.upperNormal, l), 0.0, 1.0) : 0.0;
    return (m.specularWeight * nacre_specular(m, w, l) + m.diffuseWeight * w.diffuse) * cosTheta;
}

#endif
