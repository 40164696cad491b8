#ifndef NACRE_DIFFUSE_GLSL
#define NACRE_DIFFUSE_GLSL

// The diffuse part of the layer: Granier & Heidrich 2003, Sec 5.

// Rd, the share that the upper boundary reflects: Eq 12. It is Schlick's reflectance averaged with
// the cosine, (20 f + 1) / 21, written with the f that the material holds.
vec3 nacre_diffuseReflectance(vec3 normalReflectance)
{
    return (20.0 * normalReflectance + 1.0) / 21.0;
}

// Td = 1 - Rd, the share that enters: Eq 13.
vec3 nacre_diffuseTransmittance(vec3 normalReflectance)
{
    return (20.0 / 21.0) * (1.0 - normalReflectance);
}

// The mean over solid angle of the cosine inside the layer: Eq 14, defined for r1 >= r0 > 0.
// ln((r1 + r0)/(r1 - r0)) is -ln(f)/2; at matched indices that logarithm times 0 has the limit 0.
// f is held above the smallest normal float for it. Below the outside index: 0, there is none.
vec3 nacre_meanRefractedCosine(vec3 eta, vec3 oneMinusEtaSquared, vec3 normalReflectance)
{
    vec3 logarithm = -0.5 * log(max(normalReflectance, vec3(1.2e-38)));
    vec3 mean = 0.5 + 0.25 * logarithm * oneMinusEtaSquared / eta;
    return mix(mean, vec3(0.0), lessThan(oneMinusEtaSquared, vec3(0.0)));
}

// rho_d = 1 + 2 cos(4pi r1 d / lambda) sqrt(Td (1 - Td)): Eq 16, with the phase of Eq 15.
// diffuseFringe is that root's double, from the host; cosPhase = cos(2pi r1 d / lambda), nacre_cosPhase.
// As a sum of two terms that are not negative: 1 - 2 sqrt(...) is at least 0, since Td (1 - Td) <= 1/4.
vec3 nacre_diffuseCoefficient(nacre_Channels diffuseFringe, vec3 cosPhase)
{
    return (1.0 - diffuseFringe) + 2.0 * diffuseFringe * (cosPhase * cosPhase);
}

#endif
