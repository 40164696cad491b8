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
//
// After order M the sum is closed as a geometric series from an estimate of C_{M+1}: exact where the
// fringes have not faded, and gone where they have. Cut off at M without it, one wavelength's
// sum q^m C_m would lack up to |q|^{M+1} / (1 - |q|).

// A film as one light meets it, one channel.
struct nacre_Film {
    float upper;        // weight of L0: mean of a^2
    float lower;        // weight of L1: mean of G
    vec2 fringe;        // G - tau of s and p, weight of q^m C_m
    vec4 ratio;         // q of s (xy) and p (zw), complex
};

// What both kinds of substrate share. a^2, |b|^2, q as above; crossing: tau.
nacre_Film nacre_film(vec2 a, vec2 bSquared, vec4 ratio, vec2 crossing)
{
    nacre_Film film;
    // 1 - |q|^2 vanishes only where nothing crosses, tau = 0; 1e-7 is its rounding.
    vec2 lower = crossing * crossing * bSquared / max(1.0 - a * a * bSquared, 1e-7);
    film.upper = 0.5 * dot(a, a);
    film.lower = 0.5 * (lower.x + lower.y);
    film.fringe = lower - crossing;
    film.ratio = ratio;
    return film;
}

// The fringes of a dielectric on a dielectric, sum (G - tau) q^m C_m, one channel: real throughout.
// C_{M+1}: from cos((M+1) phi) = 2 cos phi cos Mphi - cos((M-1) phi), each part faded by the square root of what
// divides the Gaussians exp(-m^2) of both sides; then on with the ratio q times that.
// One tail for both polarisations, with the q of s, the larger one.
float nacre_fringeSum(nacre_Film film, float c[NACRE_ORDERS], float coherence)
{
    vec2 q = film.ratio.xz;
    vec2 power = film.fringe;
    float sum = 0.0, last = 1.0, previous = 1.0;
    for (int m = 0; m < NACRE_ORDERS; ++m) {
        power *= q;
        sum += (power.x + power.y) * c[m];
        previous = last;
        last = c[m];
    }
    power *= q;
    float fade = NACRE_ORDERS == 2 ? coherence : pow(coherence, 2.0 / float(NACRE_ORDERS));
    float next = fade * (2.0 * c[0] * last - fade * previous);
    float r = q.x * fade;
    // The denominator's bound is that of the whole series; curves with negative lobes can pass it.
    float whole = 1.0 - abs(q.x);
    float tail = (next - r * last) / max(1.0 - 2.0 * r * c[0] + r * r, max(whole * whole, 1e-6));
    return sum + (power.x + power.y) * tail;
}

// The rest of one polarisation's complex series after its last term: next = (G - tau) q^{M+1} C_{M+1}.
float nacre_fringeTail(vec2 next, vec2 ratio, float largest)
{
    vec2 d = vec2(1.0 - ratio.x, -ratio.y);
    float whole = 1.0 - largest;
    return dot(next, d) / max(dot(d, d), max(whole * whole, 1e-6));
}

// The same over a metal, Re sum (G - tau) q^m C_m with q and C complex; here s and p have a tail each.
// C_{M+1} = C_M C_1 times the fade.
float nacre_fringeSumMetal(nacre_Film film, vec2 c[NACRE_ORDERS], float coherence)
{
    vec2 qs = film.ratio.xy, qp = film.ratio.zw;
    vec2 powerS = vec2(film.fringe.x, 0.0), powerP = vec2(film.fringe.y, 0.0);
    vec2 last = vec2(1.0, 0.0);
    float sum = 0.0;
    for (int m = 0; m < NACRE_ORDERS; ++m) {
        powerS = nacre_product(powerS, qs);
        powerP = nacre_product(powerP, qp);
        sum += nacre_product(powerS + powerP, c[m]).x;
        last = c[m];
    }
    float fade = NACRE_ORDERS == 2 ? coherence : pow(coherence, 2.0 / float(NACRE_ORDERS));
    vec2 fadedFirst = fade * c[0];
    vec2 next = nacre_product(fadedFirst, last);
    vec2 nextS = nacre_product(nacre_product(powerS, qs), next);
    vec2 nextP = nacre_product(nacre_product(powerP, qp), next);
    return sum + nacre_fringeTail(nextS, nacre_product(qs, fadedFirst), length(qs)) +
           nacre_fringeTail(nextP, nacre_product(qp, fadedFirst), length(qp));
}

// rho of one channel. rootUpper, rootLower: sqrt L0, sqrt L1.
// Differs: the colours of a film can lie outside the primaries' gamut; neither end leaves [0, 1].
float nacre_filmReflectance(nacre_Film film, float fringes, float rootUpper, float rootLower)
{
    float bounded = min(fringes, 1.0 - film.upper - film.lower);
    return max(film.upper * rootUpper * rootUpper + film.lower * rootLower * rootLower + bounded * rootUpper * rootLower, 0.0);
}

#endif
