#ifndef NACRE_PHYSICAL_LOBES_GLSL
#define NACRE_PHYSICAL_LOBES_GLSL

// What normalises the two lobes of quality `physical`, where the material asks for it. They enter as roots,
// which the fringes multiply.

#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_NORMALISED

// What a Phong lobe cos^e gains when it is normalised, apart from the host's (e + 2) / 2pi: one over
// this. Differs: (e + 2) / 2pi is exact at normal incidence alone, towards the horizon a lobe loses half
// of itself to it. Divided by the larger cosine it is reciprocal, loses far less and never gains: for
// e >= 1 the albedo stays <= 1 at every angle. Below, the lobe is so wide that the quotient would gain
// (up to 2 at e = 0), so it is blended to 1.
float nacre_lobeFlattening(float exponent, float cosLarger)
{
    return 1.0 + min(exponent, 1.0) * (cosLarger - 1.0);
}

vec3 nacre_lobeFlattening(float exponent, vec3 cosLarger)
{
    return 1.0 + min(exponent, 1.0) * (cosLarger - 1.0);
}

// Root of what the lower lobe's (e + 2) / 2pi has to be multiplied by. Inside, solid angles are eta^2
// times those outside. A lobe that the tilt turns away from its own mirror direction, towards the normal,
// is flattened by less than it gains: by up to (e + 2) / (e + 1), which is taken off as the tilt grows
// to half the lobe's width, 1 / sqrt (e + 1). At e = 0 there is no direction to turn away from.
// sineOfTilt: of the angle between the boundaries.
nacre_Channels nacre_lowerLobeScale(nacre_Channels eta, float sineOfTilt, float exponent)
{
    float apart = min(2.0 * sineOfTilt * sqrt(exponent + 1.0), 1.0) * min(4.0 * exponent, 1.0);
    return eta * sqrt((exponent + 2.0 - apart) / (exponent + 2.0));
}

#endif

#endif
