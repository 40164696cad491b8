#ifndef NACRE_UPPER_LOBE_GLSL
#define NACRE_UPPER_LOBE_GLSL

// 1 - <r_i, o>, the lobe of the upper boundary: Granier & Heidrich 2003, Eq 6.
// cosThetaI = <n0, l>, cosThetaO = <n0, v>, halfVector = l + v.
// Differs: the cosine 2 cosThetaI cosThetaO - <l, v> is taken from 1 as a sum of squares, since
// exponents of 1e6 see what its rounding leaves of it.
float nacre_upperLobeOneMinus(vec3 upperNormal, vec3 halfVector, float cosThetaI, float cosThetaO)
{
#if NACRE_STABLE_LOBES
    vec3 across = halfVector - upperNormal * (cosThetaI + cosThetaO);
    float along = cosThetaI - cosThetaO;
    return 0.5 * (dot(across, across) + along * along);
#else
    return 0.5 * dot(halfVector, halfVector) - 2.0 * cosThetaI * cosThetaO;  // <l, v> = |l + v|^2 / 2 - 1
#endif
}

#endif
