#ifndef NACRE_BOUNDARY_GLSL
#define NACRE_BOUNDARY_GLSL

#if NACRE_PHYSICAL && NACRE_SPECULAR

// Fresnel's equations at the two boundaries, one channel, exact: (s, p) in a vec2. Born & Wolf, Sec 1.5.
// Cosines: cosTheta outside, cosRefracted in the layer, both to the boundary's normal. Denominators
// are held above 1e-18, their products above 1e-30: they vanish at grazing incidence on a boundary that is
// not there.

// One over each, for the price of one division; neither is negative.
vec2 nacre_inverses(vec2 a)
{
    return a.yx / max(a.x * a.y, 1e-30);
}

// Amplitudes [a] that the boundary outside - layer reflects.
// Differs: (eta c - g)/(eta c + g), expanded by its denominator, has the numerator -(1 - eta^2), which the
// host knows to the last bit; that of p likewise. Nothing cancels near matched indices.
vec2 nacre_upperAmplitudes(float eta, float oneMinusEtaSquared, float cosTheta, float cosRefracted)
{
    vec2 inverse = nacre_inverses(vec2(eta * cosTheta + cosRefracted, cosTheta + eta * cosRefracted));
    float etaSquared = eta * eta;
    float p = cosTheta * cosTheta * (1.0 + etaSquared) - etaSquared;
    return oneMinusEtaSquared * vec2(-1.0, p) * (inverse * inverse);
}

// Root of what the boundary outside - layer lets through, sqrt (1 - a^2).
// 1 - a^2 = 4 eta c g / (eta c + g)^2 for s; p has the same numerator. As a product it keeps its digits at
// grazing angles.
vec2 nacre_crossing(float eta, float cosTheta, float cosRefracted)
{
    float root = 2.0 * sqrt(eta * cosTheta * cosRefracted);
    return root * nacre_inverses(vec2(eta * cosTheta + cosRefracted, cosTheta + eta * cosRefracted));
}

// Amplitudes [b] that the boundary layer - object reflects, the object a dielectric.
// substrate is (r2 / r1)^2, sineSquared that of the angle in the layer. Beyond its critical angle the
// boundary reflects all: the phase that a film on it would add is left out (it moves no energy).
vec2 nacre_lowerAmplitudes(float substrate, float sineSquared, float cosRefracted)
{
    float w = sqrt(max(substrate - sineSquared, 0.0));  // r2/r1 times the cosine below
    vec2 g = vec2(1.0, substrate) * cosRefracted;
    return (g - w) * nacre_inverses(g + w);
}

#if NACRE_METAL

// The same for a metal, (r2 / r1)^2 complex: amplitudes of s in xy, of p in zw, complex. An absorbed wave
// goes as exp(i (n + i k) x), so the imaginary part is not negative.
vec4 nacre_lowerAmplitudesMetal(vec2 substrate, float sineSquared, float cosRefracted)
{
    float real = substrate.x - sineSquared;
    vec2 w = nacre_complexRoot(vec2(substrate.y > 0.0 ? real : max(real, 0.0), substrate.y));  // as the dielectric's
    float w2 = dot(w, w);
    float g = cosRefracted;
    vec2 s = vec2(g * g - w2, -2.0 * g * w.y) / max((g + w.x) * (g + w.x) + w.y * w.y, 1e-18);
    vec2 below = g * substrate + w;
    vec2 p = vec2(dot(substrate, substrate) * (g * g) - w2, 2.0 * g * (substrate.y * w.x - substrate.x * w.y));
    return vec4(s, p / max(dot(below, below), 1e-18));
}

#endif

#endif

#endif
