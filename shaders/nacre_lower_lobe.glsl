#ifndef NACRE_LOWER_LOBE_GLSL
#define NACRE_LOWER_LOBE_GLSL

// The lobe of the lower boundary inside the layer: Granier & Heidrich 2003, Eq 10.
// Nothing is refracted: dot products give the same for three channels at once.

// <t, n1> of the ray refracted through the upper boundary. cosTheta and cosNormal are the cosines of
// the direction outside to the upper and to the lower normal; cosRefracted its cosine inside.
vec3 nacre_lowerCosine(vec3 eta, float cosBetween, float cosTheta, float cosNormal, vec3 cosRefracted)
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
vec3 nacre_lowerLobeOneMinus(vec3 eta, vec2 halfAcross, vec2 upperAcross, float cosSum, vec3 cosRefractedSum, vec3 along)
{
    vec3 g = eta * cosSum - cosRefractedSum;
    vec3 x = g * upperAcross.x - eta * halfAcross.x;
    vec3 y = g * upperAcross.y - eta * halfAcross.y;
    return 0.5 * (x * x + y * y + along * along);
}

#endif
