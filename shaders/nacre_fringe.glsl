#ifndef NACRE_FRINGE_GLSL
#define NACRE_FRINGE_GLSL

// What an RGB sensor makes of a fringe: C(x) = integral S(lambda) exp(2 pi i x / lambda) dlambda for the path difference x, per
// channel, S the channel's curve with the light's spectrum, 1 for a white reflector. The m-th harmonic of
// the fringe at x is C(m x). A cosine at one wavelength never fades; C fades as real fringes do, and
// thick layers lose their colour.
//
// Here without a sampler, for Rec.709 under equal-energy light adapted to D65; nacre_fringe_table.glsl has the
// sum over all harmonics from a texture, for these and any other curves.

#if NACRE_PHYSICAL && NACRE_SAMPLER_FREE

// The fringes of one path through the layer.
struct nacre_Fringe {
    vec3 order[NACRE_ORDERS];  // C, its cosine or its sine part, of 1, 2, ... times the path
    float coherence;           // |C| of the luminance at the last of these: what is left of the contrast
};

// Four spectral lines with Gaussian profiles, which the three channels share: the least-squares fit to C
// by tests/spectral/fit_fringe.py. Residual, at most: R 0.077, G 0.042, B 0.039 (up to 0.45 um: 0.0016).
// Wavelengths 451, 525, 555, 604 nm, cycles per um; e-folding paths 2.1, 1.6, 2.1, 2.8 um, as
// -log2(e) / s^2.
const vec4 nacre_fringeLines = vec4(2.21777322, 1.90322369, 1.80066289, 1.65613586);
const vec4 nacre_fringeDecay = vec4(-0.326053914, -0.597588231, -0.333458856, -0.182555639);
const vec4 nacre_fringeRed = vec4(0.144105461, -0.766282724, -0.123086929, 1.74525443);
const vec4 nacre_fringeGreen = vec4(-0.142321879, 0.457108368, 0.991535075, -0.306281223);
const vec4 nacre_fringeBlue = vec4(1.11180163, 0.0629806261, -0.182909394, 0.00815675084);

// The phase of each line, less its whole cycles: no driver reduces a large argument.
highp vec4 nacre_linePhase(highp float path)
{
    highp vec4 cycles = nacre_fringeLines * path;
    return 6.28318531 * (cycles - floor(cycles + 0.5));
}

// The three channels of four lines.
vec3 nacre_ofLines(vec4 line)
{
    return vec3(dot(nacre_fringeRed, line), dot(nacre_fringeGreen, line), dot(nacre_fringeBlue, line));
}

// Harmonics without further cosines: cos mphi and sin mphi by Chebyshev's recursion from the two before
// (first, and zeroth), the Gaussian's m^2-th power from the odd powers 1, 3, 5, ...
nacre_Fringe nacre_lineHarmonics(highp float path, vec4 cosine, vec4 first, vec4 zeroth)
{
    nacre_Fringe f;
    vec4 decay = exp2(nacre_fringeDecay * (path * path));
    vec4 decayStep = decay, decaySquared = decay * decay;
    vec4 wave = first, before = zeroth;
    for (int m = 0; m < NACRE_ORDERS; ++m) {
        f.order[m] = nacre_ofLines(wave * decay);
        // The line at 525 nm fades as the luminance does, within 0.08.
        f.coherence = decay.y;
        vec4 next = 2.0 * cosine * wave - before;
        before = wave;
        wave = next;
        decayStep *= decaySquared;
        decay *= decayStep;
    }
    return f;
}

nacre_Fringe nacre_cosineFringe(highp float path)
{
    vec4 cosine = cos(nacre_linePhase(path));
    return nacre_lineHarmonics(path, cosine, cosine, vec4(1.0));
}

nacre_Fringe nacre_sineFringe(highp float path)
{
    vec4 phase = nacre_linePhase(path);
    return nacre_lineHarmonics(path, cos(phase), sin(phase), vec4(0.0));
}

// C of each channel's own path, its cosine part: what the diffuse part takes.
vec3 nacre_firstFringeOf(highp float path)
{
    return nacre_ofLines(cos(nacre_linePhase(path)) * exp2(nacre_fringeDecay * (path * path)));
}

vec3 nacre_firstFringe(highp nacre_Channels path)
{
#if NACRE_DISPERSION
    return vec3(nacre_firstFringeOf(path.x).x, nacre_firstFringeOf(path.y).y, nacre_firstFringeOf(path.z).z);
#else
    return nacre_firstFringeOf(path);
#endif
}

#endif

#endif
