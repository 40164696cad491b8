#ifndef NACRE_POWER_GLSL
#define NACRE_POWER_GLSL

#if NACRE_STABLE_LOBES
// log(1 - u) for 0 <= u < 1, to about 2e-7 relative: a Phong lobe of exponent e reads its cosine
// as x^e = exp(e log x), and e times the rounding of 1 - u would be its error.
// Below 1/2: log(1 - u) = -2 atanh(s), s = u / (2 - u) <= 1/3, as the odd series
// 2 s (1 + z/3 + z^2/5 + z^3/7 + ...), z = s^2 <= 1/9, its coefficients moved to make up for the
// terms left out (minimax on [0, 1/9], residual 4.5e-9 relative).
// Above: the built-in logarithm. What it errs, 2^-21 at most by the GLSL specification, times
// e x^e <= 0.53 for every e is 2.5e-7.
float nacre_logOneMinus(float u)
{
    float s = u / (2.0 - u);
    float z = s * s;
    float series = -2.0 * s * (1.0 + z * (0.333332081 + z * (0.200107636 + z * (0.140009024 + z * 0.140059948))));
    return u < 0.5 ? series : log(1.0 - min(u, 0.99999994));
}

vec3 nacre_logOneMinus(vec3 u)
{
    return vec3(nacre_logOneMinus(u.x), nacre_logOneMinus(u.y), nacre_logOneMinus(u.z));
}
#endif

// max(1 - u, 0)^exponent, where 0^0 = 1 (Eq 12 is derived that way).
// Without NACRE_STABLE_LOBES by pow(), above 1e-30, where it has a value; 0^0 is 1 there too.
#if NACRE_STABLE_LOBES
float nacre_powerOneMinus(float u, float exponent)
{
    float beyond = exponent > 0.0 ? 0.0 : 1.0;
    return u < 1.0 ? exp(exponent * nacre_logOneMinus(u)) : beyond;
}

vec3 nacre_powerOneMinus(vec3 u, float exponent)
{
    return vec3(nacre_powerOneMinus(u.x, exponent), nacre_powerOneMinus(u.y, exponent),
                nacre_powerOneMinus(u.z, exponent));
}
#else
float nacre_powerOneMinus(float u, float exponent)
{
    return pow(max(1.0 - u, 1e-30), exponent);
}

vec3 nacre_powerOneMinus(vec3 u, float exponent)
{
    return pow(max(1.0 - u, 1e-30), vec3(exponent));
}
#endif

#endif
