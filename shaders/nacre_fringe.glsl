#ifndef NACRE_FRINGE_GLSL
#define NACRE_FRINGE_GLSL

// What an RGB sensor makes of a fringe: C(x) = integral S(lambda) exp(2 pi i x / lambda) dlambda for the path difference x, per
// channel, S the channel's curve with the light's spectrum, 1 for a white reflector. The m-th harmonic of
// the fringe at x is C(m x). A cosine at one wavelength never fades; C fades as real fringes do, and
// thick layers lose their colour.
//
// Two forms: here without a sampler, for Rec.709 under equal-energy light adapted to D65; from a texture
// for any other curves, nacre_fringe_table.glsl.

// The fringes of a path through the layer, per channel.
struct nacre_Fringe {
    vec3 order[NACRE_ORDERS];  // C, its cosine or its sine part, of 1, 2, ... times the path
    vec3 coherence;            // |C| of the luminance at the last of these: what is left of the contrast
};

// Four spectral lines with Gaussian profiles, which the three channels share: the least-squares fit to C
// by tests/spectral/fit_fringe.py. Residual, at most: R 0.077, G 0.042, B 0.039 (up to 0.45 um: 0.0016).
// In films of up to 800 nm on dielectrics 0.07 CIEDE2000 on average, all
// errors of the quality included; the table 0.05.
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

// Harmonics without further cosines: cos mphi and sin mphi by Chebyshev's recursion from the two before
// (first, and zeroth), the Gaussian's m^2-th power from the odd powers 1, 3, 5, ...
nacre_Fringe nacre_lineHarmonics(highp float path, vec4 cosine, vec4 first, vec4 zeroth)
{
    nacre_Fringe f;
    vec4 decay = exp2(nacre_fringeDecay * (path * path));
    vec4 decayStep = decay, decaySquared = decay * decay;
    vec4 wave = first, before = zeroth;
    for (int m = 0; m < NACRE_ORDERS; ++m) {
        vec4 line = wave * decay;
        f.order[m] = vec3(dot(nacre_fringeRed, line), dot(nacre_fringeGreen, line), dot(nacre_fringeBlue, line));
        // The line at 525 nm fades as the luminance does, within 0.08.
        f.coherence = vec3(decay.y);
        vec4 next = 2.0 * cosine * wave - before;
        before = wave;
        wave = next;
        decayStep *= decaySquared;
        decay *= decayStep;
    }
    return f;
}

nacre_Fringe nacre_cosineFringeAt(highp float path)
{
    vec4 cosine = cos(nacre_linePhase(path));
    return nacre_lineHarmonics(path, cosine, cosine, vec4(1.0));
}

nacre_Fringe nacre_sineFringeAt(highp float path)
{
    vec4 phase = nacre_linePhase(path);
    return nacre_lineHarmonics(path, cos(phase), sin(phase), vec4(0.0));
}

// Of each channel's own path.
nacre_Fringe nacre_perChannel(nacre_Fringe r, nacre_Fringe g, nacre_Fringe b)
{
    for (int m = 0; m < NACRE_ORDERS; ++m) r.order[m] = vec3(r.order[m].x, g.order[m].y, b.order[m].z);
    r.coherence = vec3(r.coherence.x, g.coherence.y, b.coherence.z);
    return r;
}

nacre_Fringe nacre_cosineFringe(highp vec3 path)
{
    return nacre_perChannel(nacre_cosineFringeAt(path.x), nacre_cosineFringeAt(path.y), nacre_cosineFringeAt(path.z));
}

nacre_Fringe nacre_sineFringe(highp vec3 path)
{
    return nacre_perChannel(nacre_sineFringeAt(path.x), nacre_sineFringeAt(path.y), nacre_sineFringeAt(path.z));
}

#endif
