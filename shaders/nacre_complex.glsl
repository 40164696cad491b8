#ifndef NACRE_COMPLEX_GLSL
#define NACRE_COMPLEX_GLSL

#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_METAL

// Complex numbers as vec2(real, imaginary).

vec2 nacre_product(vec2 a, vec2 b)
{
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// The root with a real part that is not negative, for an imaginary part that is not negative.
// Differs: the larger part is the root of a sum of two terms of one sign, the smaller one follows from
// the product of both, so neither loses digits.
vec2 nacre_complexRoot(vec2 a)
{
    float larger = sqrt(0.5 * (length(a) + abs(a.x)));
    float smaller = 0.5 * a.y / max(larger, 1e-18);
    return a.x >= 0.0 ? vec2(larger, smaller) : vec2(smaller, larger);
}

#endif

#endif
