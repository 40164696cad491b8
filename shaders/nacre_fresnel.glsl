#ifndef NACRE_FRESNEL_GLSL
#define NACRE_FRESNEL_GLSL

// Reflectance F of the upper boundary. Schlick 1994; Granier & Heidrich 2003, Eq 7.
// cosTheta in [0, 1]. Differs: Eq 10 prints F(i), read as F(-i) as in Eq 6.
nacre_Channels nacre_reflectance(nacre_Channels normalReflectance, float cosTheta)
{
    float m = 1.0 - cosTheta;
    float m2 = m * m;
    return normalReflectance + (1.0 - normalReflectance) * (m2 * m2 * m);
}

// 1 - (1 - cosTheta)^5, the angular part of the transmittance 1 - F (Eq 9), multiplied out:
// the interference takes its root, which at grazing angles would see only the rounding of 1 - F.
float nacre_transmittanceShape(float cosTheta)
{
    return cosTheta * (5.0 + cosTheta * (-10.0 + cosTheta * (10.0 + cosTheta * (-5.0 + cosTheta))));
}

vec3 nacre_transmittanceShape(vec3 cosTheta)
{
    return cosTheta * (5.0 + cosTheta * (-10.0 + cosTheta * (10.0 + cosTheta * (-5.0 + cosTheta))));
}

// Square of the cosine inside the layer, by Snell's law; negative: total reflection.
// cosTheta is the cosine outside, to the upper normal.
nacre_Channels nacre_refractedCosineSquared(nacre_Channels etaSquared, nacre_Channels oneMinusEtaSquared, float cosTheta)
{
    return oneMinusEtaSquared + etaSquared * (cosTheta * cosTheta);
}

// The cosine itself; 0 for total reflection.
nacre_Channels nacre_refractedCosine(nacre_Channels cosSquared)
{
#if NACRE_TOTAL_REFLECTION
    return sqrt(max(cosSquared, 0.0));
#else
    return sqrt(cosSquared);
#endif
}

#endif
