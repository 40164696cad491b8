#ifndef NACRE_THICKNESS_GLSL
#define NACRE_THICKNESS_GLSL

// Thickness of the layer at a point: Granier & Heidrich 2003, Sec 3.2 and 6.1, Perlin noise between
// two bounds. Value in w, in µm; in xyz the gradient of the noise behind it per feature, a number
// near 1 that the lower normal takes (a gradient in nm per unit of length would tilt nothing).
// p is the point in the object's own space, so that the layer stays on a moving object.
// Differs: noise seldom comes near -1 and 1, so it is stretched by 1.6 (two standard deviations of one
// octave) before it is clamped to the bounds; where clamped, the layer is level.
vec4 nacre_thickness(nacre_Material m, vec3 p)
{
    if (m.noiseOctaves < 1 || !(m.noiseFrequency > 0.0)) {
        return vec4(0.0, 0.0, 0.0, 0.5 * (m.thicknessLeastUm + m.thicknessMostUm));
    }
    vec4 noise = nacre_turbulence(p * m.noiseFrequency, m.noiseOctaves, m.noiseSeed) * 1.6;
    float share = clamp(0.5 + 0.5 * noise.w, 0.0, 1.0);
    vec3 gradient = abs(noise.w) < 1.0 ? noise.xyz : vec3(0.0);
    float thickness = mix(m.thicknessLeastUm, m.thicknessMostUm, share);
    // A point that is not finite has no noise; a comparison that NaN fails gives it the lower bound.
    return vec4(gradient, thickness <= m.thicknessMostUm ? thickness : m.thicknessLeastUm);
}

#endif
