#ifndef NACRE_FRINGE_TABLE_GLSL
#define NACRE_FRINGE_TABLE_GLSL

// The fringes of all internal bounces at once, from a texture that the host makes of nacre::FringeTable:
//     F(x, q, k) = (1 - q^2) sum_{m>=1} q^(m-1) Re e^(i m k pi/4) C(m x)
// for the path difference x and the ratio q e^(i k pi/4) of one bounce to the one before. Along the width the root of x,
// since short paths have the sharper fringes; along the height q, from -1 to 1, in NACRE_FRINGE_ROWS rows for each of the
// phases k = 0 to 3. A dielectric's ratio is real and reads the first rows alone. One look-up serves three channels and
// all orders. Filter linear, clamped to the edge, no mipmaps.

#if NACRE_PHYSICAL && NACRE_FRINGE_TABLE

// Stored as (55 F + 127) / 255, between 0 and 1 for any format.
const float nacre_fringeScale = 255.0 / 55.0;
const float nacre_fringeShift = 127.0 / 55.0;

// A texel as it is stored. Beyond the table's range fringes have less than 0.3 % of their contrast; its last column is 0.
vec3 nacre_fringeTexel(sampler2D table, highp float path, float ratio, float phase)
{
    highp float x = sqrt(path * (1.0 / NACRE_FRINGE_RANGE_UM)) * (1.0 - 1.0 / NACRE_FRINGE_TEXELS) + 0.5 / NACRE_FRINGE_TEXELS;
    highp float row = ratio * (0.5 * (NACRE_FRINGE_ROWS - 1.0)) + (phase + 0.5) * NACRE_FRINGE_ROWS;
    return textureLod(table, vec2(x, row * (1.0 / (NACRE_FRINGE_ROWS * NACRE_FRINGE_PHASES))), 0.0).xyz;
}

// C of each channel's own path, its cosine part: what the diffuse part takes. It is F at q = 0.
vec3 nacre_firstFringe(sampler2D table, highp nacre_Channels path)
{
#if NACRE_DISPERSION
    vec3 texel = vec3(nacre_fringeTexel(table, path.x, 0.0, 0.0).x, nacre_fringeTexel(table, path.y, 0.0, 0.0).y,
                      nacre_fringeTexel(table, path.z, 0.0, 0.0).z);
#else
    vec3 texel = nacre_fringeTexel(table, path, 0.0, 0.0);
#endif
    return texel * nacre_fringeScale - nacre_fringeShift;
}

#if NACRE_METAL

// q F(x, q, k) with the phase of ratio, angle, moved to the table's k = steps. What lies between the two becomes a path,
// which is exact at the channel's own wavelength. pathPerRadian: lambda / 2pi.
vec3 nacre_fringeOfPhase(sampler2D table, highp float path, float size, float angle, float steps, highp float pathPerRadian)
{
    highp float moved = path + (angle - steps * (3.14159265 / NACRE_FRINGE_PHASES)) * pathPerRadian;
    steps = moved < 0.0 ? -steps : steps;  // C(-x) is the conjugate of C(x)
    float turn = floor(steps * (1.0 / NACRE_FRINGE_PHASES));
    size = turn == 0.0 || turn == -2.0 ? size : -size;
    vec3 texel = nacre_fringeTexel(table, abs(moved), size, steps - turn * NACRE_FRINGE_PHASES);
    return size * (texel * nacre_fringeScale - nacre_fringeShift);
}

// The same for any complex ratio: between the two phases beside its own, whose errors cancel in the first order.
vec3 nacre_fringeOfRatio(sampler2D table, highp float path, vec2 ratio, highp float pathPerRadian)
{
    float angle = ratio.x == 0.0 && ratio.y == 0.0 ? 0.0 : atan(ratio.y, ratio.x);
    float steps = floor(angle * (NACRE_FRINGE_PHASES / 3.14159265));
    float share = angle * (NACRE_FRINGE_PHASES / 3.14159265) - steps;
    float size = length(ratio);
    return mix(nacre_fringeOfPhase(table, path, size, angle, steps, pathPerRadian),
               nacre_fringeOfPhase(table, path, size, angle, steps + 1.0, pathPerRadian), share);
}

#endif

#endif

#endif
