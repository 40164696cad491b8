#ifndef NACRE_AIRY_GLSL
#define NACRE_AIRY_GLSL

// The sum over the internal bounces on two lobes L0 and L1 (Airy 1833; Born & Wolf, Sec 7.6.1). Per
// polarisation, with a, b the amplitudes of the boundaries, q = -a b, tau what crosses the upper one both
// ways (1 - a^2 in the mirror direction) and G = tau^2 |b|^2 / (1 - |q|^2) all that comes back through it:
//     rho = a^2 L0 + G L1 - 2 (tau - G) sqrt (L0 L1) Re sum_{m>=1} q^m C_m,
// averaged over s and p. Eq 5 of Granier & Heidrich 2003 is its part of order 1 with G = R12.
//
// At L0 = L1 and one wavelength this is Airy's sum exactly. Lobes apart lose their fringes, those among
// the internal bounces too: a ray leaves the film in another direction than the one before it. It is
// linear in sqrt (L0 L1), whose integral Cauchy and Schwarz bound by the lobes' own, between two ends that
// both stay at or below 1: a^2 + G, since (1 - a^2)(1 - b^2) >= 0, and Airy. So lobes that are normalised
// create no energy.

#if NACRE_PHYSICAL && NACRE_SPECULAR

// A film as one light meets it, one channel.
struct nacre_Film {
    float upper;   // weight of L0: mean of a^2
    float lower;   // weight of L1: mean of G
    vec2 fringe;   // G - tau of s and p, weight of q^m C_m
    vec2 inverse;  // 1 / (1 - |q|^2)
#if NACRE_METAL
    vec4 ratio;    // q of s (xy) and p (zw), complex
#else
    vec2 ratio;    // q of s and p
#endif
};

// What both kinds of substrate share. a^2, |b|^2 as above; crossing: tau.
void nacre_weigh(inout nacre_Film film, vec2 aSquared, vec2 bSquared, vec2 crossing)
{
    // 1 - |q|^2 vanishes only where nothing crosses, tau = 0; 1e-7 is its rounding.
    film.inverse = nacre_inverses(max(1.0 - aSquared * bSquared, 1e-7));
    vec2 lower = crossing * crossing * bSquared * film.inverse;
    film.upper = 0.5 * (aSquared.x + aSquared.y);
    film.lower = 0.5 * (lower.x + lower.y);
    film.fringe = lower - crossing;
}

// rho of a film, given its fringes sum (G - tau) Re q^m C_m over both polarisations.
// Differs: the colours of a film can lie outside the primaries' gamut. Below 0 they end; above, a channel keeps what a metal
// at grazing angles has (1.083 at a cosine of 0.05, its luminance below 1), with room for other primaries.
vec3 nacre_filmReflectance(nacre_Film film, vec3 fringes, float rootUpper, float rootLower)
{
    vec3 bounded = min(fringes, 1.1 - film.upper - film.lower);
    return max(film.upper * rootUpper * rootUpper + film.lower * rootLower * rootLower + bounded * (rootUpper * rootLower), 0.0);
}

#if NACRE_FRINGE_TABLE

// The fringes from the table, all orders of them.
vec3 nacre_fringeSum(sampler2D table, nacre_Film film, highp float path, highp float pathPerRadian)
{
    vec2 weight = film.fringe * film.inverse;
#if NACRE_METAL
    return weight.x * nacre_fringeOfRatio(table, path, film.ratio.xy, pathPerRadian) +
           weight.y * nacre_fringeOfRatio(table, path, film.ratio.zw, pathPerRadian);
#else
    weight *= film.ratio * nacre_fringeScale;
    float shift = (weight.x + weight.y) * (nacre_fringeShift / nacre_fringeScale);
    return weight.x * nacre_fringeTexel(table, path, film.ratio.x, 0.0) + weight.y * nacre_fringeTexel(table, path, film.ratio.y, 0.0) - shift;
#endif
}

#endif

#if NACRE_SAMPLER_FREE

// Without the table the sum is cut off after order M = NACRE_ORDERS and closed as a geometric series from an estimate
// of C_{M+1}: exact where the fringes have not faded, and gone where they have. Cut off without it, one wavelength's
// sum q^m C_m would lack up to |q|^{M+1} / (1 - |q|).

// How much C_{M+1} has faded against what one wavelength would make of C_M and C_1: the square root of what
// divides the Gaussians exp(-m^2) of both sides.
float nacre_fade(float coherence)
{
    return NACRE_ORDERS == 2 ? coherence : pow(coherence, 2.0 / float(NACRE_ORDERS));
}

// Over a dielectric: real throughout. C_{M+1} from cos((M+1) phi) = 2 cos phi cos Mphi - cos((M-1) phi).
// One tail for both polarisations, with the q of s, the larger one.
vec3 nacre_fringeSum(nacre_Film film, nacre_Fringe c)
{
#if NACRE_METAL
    vec2 q = film.ratio.xz;
#else
    vec2 q = film.ratio;
#endif
    vec2 power = film.fringe;
    vec3 sum = vec3(0.0), last = vec3(1.0), previous = vec3(1.0);
    for (int m = 0; m < NACRE_ORDERS; ++m) {
        power *= q;
        sum += (power.x + power.y) * c.order[m];
        previous = last;
        last = c.order[m];
    }
    power *= q;
    float fade = nacre_fade(c.coherence);
    vec3 next = fade * (2.0 * c.order[0] * last - fade * previous);
    float r = q.x * fade;
    // The denominator's bound is that of the whole series; curves with negative lobes can pass it.
    float whole = 1.0 - abs(q.x);
    vec3 tail = (next - r * last) / max(1.0 - 2.0 * r * c.order[0] + r * r, max(whole * whole, 1e-6));
    return sum + (power.x + power.y) * tail;
}

#if NACRE_METAL

// The rest of one polarisation's complex series after its last term: next = (G - tau) q^{M+1} C_{M+1}.
float nacre_fringeTail(vec2 next, vec2 ratio, float largest)
{
    vec2 d = vec2(1.0 - ratio.x, -ratio.y);
    float whole = 1.0 - largest;
    return dot(next, d) / max(dot(d, d), max(whole * whole, 1e-6));
}

// Over a metal: q and C complex; here s and p have a tail each. C_{M+1} = C_M C_1 times the fade.
float nacre_fringeSumMetal(nacre_Film film, nacre_Fringe cosine, nacre_Fringe sine, int channel)
{
    vec2 qs = film.ratio.xy, qp = film.ratio.zw;
    vec2 powerS = vec2(film.fringe.x, 0.0), powerP = vec2(film.fringe.y, 0.0);
    vec2 last = vec2(1.0, 0.0);
    float sum = 0.0;
    for (int m = 0; m < NACRE_ORDERS; ++m) {
        powerS = nacre_product(powerS, qs);
        powerP = nacre_product(powerP, qp);
        last = vec2(cosine.order[m][channel], sine.order[m][channel]);
        sum += nacre_product(powerS + powerP, last).x;
    }
    vec2 fadedFirst = nacre_fade(cosine.coherence) * vec2(cosine.order[0][channel], sine.order[0][channel]);
    vec2 next = nacre_product(fadedFirst, last);
    vec2 nextS = nacre_product(nacre_product(powerS, qs), next);
    vec2 nextP = nacre_product(nacre_product(powerP, qp), next);
    return sum + nacre_fringeTail(nextS, nacre_product(qs, fadedFirst), length(qs)) +
           nacre_fringeTail(nextP, nacre_product(qp, fadedFirst), length(qp));
}

#endif
#endif

#endif

#endif
