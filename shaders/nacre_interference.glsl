#ifndef NACRE_INTERFERENCE_GLSL
#define NACRE_INTERFERENCE_GLSL

// R + T + 2 cos(2Phi) sqrt(R T). Granier & Heidrich 2003, Eq 5 (and Eq 4, after Born & Wolf).
// Differs: as the sum of squares (sqrt R - sqrt T)^2 + 4 sqrt R sqrt T cos^2 Phi. Nothing cancels where the two
// extinguish each other, it is never negative, and sqrt R sqrt T holds where R T would underflow.
vec3 nacre_interference(nacre_Channels sqrtR, nacre_Channels sqrtT, vec3 cosPhase)
{
    nacre_Channels difference = sqrtR - sqrtT;
    return difference * difference + 4.0 * sqrtR * sqrtT * (cosPhase * cosPhase);
}

#endif
