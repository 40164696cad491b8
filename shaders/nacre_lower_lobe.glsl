#ifndef NACRE_LOWER_LOBE_GLSL
#define NACRE_LOWER_LOBE_GLSL

// The lobe of the lower boundary inside the layer: Granier & Heidrich 2003, Eq 10.
// Nothing is refracted: dot products give the same for three channels at once.

#if NACRE_TILT

// <t, n1> of the ray refracted through the upper boundary. cosTheta and cosNormal are the cosines of
// the direction outside to the upper and to the lower normal; cosRefracted its cosine inside.
nacre_Channels nacre_lowerCosine(nacre_Channels eta, float cosBetween, float cosTheta, float cosNormal, nacre_Channels cosRefracted)
{
    return (eta * cosTheta - cosRefracted) * cosBetween - eta * cosNormal;
}

// 1 - <r_ti, -t_o>.
// Differs: with s = t_i + t_o = -eta (l + v) + g n0 the cosine is taken from 1 as half the sum of the
// squares of s across n1 and of the difference of the two rays along n1, so that nothing cancels.
//   halfAcross, upperAcross  l + v and n0 in the plane across n1 (nacre_frame)
//   cosSum                   <n0, l> + <n0, v>
//   cosRefractedSum          the same inside, cosTi + cosTo
//   along                    <t_i, n1> - <t_o, n1>
nacre_Channels nacre_lowerLobeOneMinus(nacre_Channels eta, vec2 halfAcross, vec2 upperAcross, float cosSum, nacre_Channels cosRefractedSum, nacre_Channels along)
{
    nacre_Channels g = eta * cosSum - cosRefractedSum;
    nacre_Channels x = g * upperAcross.x - eta * halfAcross.x;
    nacre_Channels y = g * upperAcross.y - eta * halfAcross.y;
    return 0.5 * (x * x + y * y + along * along);
}

#else

// 1 - <r_ti, -t_o> between parallel boundaries.
//   halfVector        l + v
//   cosThetaI, O      <n0, l>, <n0, v>; cosRefractedI, O the same inside, cosTi and cosTo
// Differs: as a sum of squares, in which cosTi - cosTo is a quotient, since the difference of the roots would cancel.
// Without NACRE_STABLE_LOBES cosTi cosTo - eta^2 (<l, v> - <n0, l> <n0, v>), taken from 1.
nacre_Channels nacre_lowerLobeOneMinus(nacre_Channels etaSquared, vec3 upperNormal, vec3 halfVector, float cosThetaI, float cosThetaO,
                                       nacre_Channels cosRefractedI, nacre_Channels cosRefractedO)
{
#if NACRE_STABLE_LOBES
    vec3 across = halfVector - upperNormal * (cosThetaI + cosThetaO);
    float difference = (cosThetaI - cosThetaO) * (cosThetaI + cosThetaO);
    nacre_Channels along = etaSquared * difference / max(cosRefractedI + cosRefractedO, 1e-18);
    return 0.5 * (etaSquared * dot(across, across) + along * along);
#else
    float cosLightView = 0.5 * dot(halfVector, halfVector) - 1.0;
    return 1.0 - cosRefractedI * cosRefractedO + etaSquared * (cosLightView - cosThetaI * cosThetaO);
#endif
}

#endif

#endif
