#ifndef NACRE_FRINGE_TABLE_GLSL
#define NACRE_FRINGE_TABLE_GLSL

// The fringes from a texture that the host makes of nacre::FringeTable: filter linear, clamped to the
// edge, no mipmaps. One look-up serves three channels. Two rows: cosine and sine part; rgb the channels,
// a what the luminance has left of its contrast.

// One texel of a path, um; row 0.25: cosine, 0.75: sine.
// Stored as C / 4 + 1/2, but for the shift of 1/510 that makes 0 and 1 exact in eight bits.
vec4 nacre_fringeTexel(sampler2D table, highp float path, float row)
{
    highp float x = path * ((NACRE_FRINGE_TEXELS - 1.0) / (NACRE_FRINGE_TEXELS * NACRE_FRINGE_RANGE_UM)) + 0.5 / NACRE_FRINGE_TEXELS;
    return textureLod(table, vec2(x, row), 0.0) * (255.0 / 64.0) - 2.0;
}

nacre_Fringe nacre_fringeAt(sampler2D table, highp float path, float row)
{
    nacre_Fringe f;
    for (int m = 0; m < NACRE_ORDERS; ++m) {
        vec4 texel = nacre_fringeTexel(table, path * float(m + 1), row);
        f.order[m] = texel.xyz;
        f.coherence = vec3(max(texel.w, 0.0));
    }
    return f;
}

nacre_Fringe nacre_cosineFringe(sampler2D table, highp vec3 path)
{
    return nacre_perChannel(nacre_fringeAt(table, path.x, 0.25), nacre_fringeAt(table, path.y, 0.25), nacre_fringeAt(table, path.z, 0.25));
}

nacre_Fringe nacre_sineFringe(sampler2D table, highp vec3 path)
{
    return nacre_perChannel(nacre_fringeAt(table, path.x, 0.75), nacre_fringeAt(table, path.y, 0.75), nacre_fringeAt(table, path.z, 0.75));
}

#endif
