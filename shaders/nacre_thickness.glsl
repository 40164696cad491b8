#ifndef NACRE_THICKNESS_GLSL
#define NACRE_THICKNESS_GLSL

#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE

// Thickness of the layer at a point: Granier & Heidrich 2003, Sec 3.2 and 6.1, Perlin noise between
// two bounds. Value in w, in um; in xyz the gradient of the noise behind it per feature, whose part
// along a surface is 1 in the root mean square for one octave: what the lower normal takes (a gradient in
// nm per unit of length would tilt nothing).
// p is the point in the object's own space, so that the layer stays on a moving object.
// Differs: noise seldom comes near -1 and 1; its standard deviation is 0.27. A smooth step between three of
// these below and above, 1 / 0.81 = 1.23, uses the whole range and levels the layer at its bounds
// without a crease, which the lower normal would show.
vec4 nacre_thickness(nacre_Material m, vec3 p)
{
    if (m.noiseOctaves < 1 || !(m.noiseFrequency > 0.0)) {
        return vec4(0.0, 0.0, 0.0, 0.5 * (m.thicknessLeastUm + m.thicknessMostUm));
    }
    vec4 noise = nacre_turbulence(p * m.noiseFrequency, m.noiseOctaves, m.noiseSeed);
    float height = clamp(1.23 * noise.w, -1.0, 1.0);
    float share = 0.5 + height * (0.75 - 0.25 * height * height);
    vec3 gradient = noise.xyz * (1.0 - height * height);
    float thickness = mix(m.thicknessLeastUm, m.thicknessMostUm, share);
    // A point that is not finite has no noise; a comparison that NaN fails gives it the lower bound. The blend may
    // exceed the upper bound by its rounding.
    return vec4(gradient, thickness >= m.thicknessLeastUm ? min(thickness, m.thicknessMostUm) : m.thicknessLeastUm);
}

#endif

#endif
