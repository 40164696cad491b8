#ifndef NACRE_NOISE_GLSL
#define NACRE_NOISE_GLSL

#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE || NACRE_LOWER_NORMAL >= NACRE_LOWER_NORMAL_INDEPENDENT

// Gradient noise in space, after Perlin 1985 ("An Image Synthesizer", the paper's [14]) with the fade
// 6t^5 - 15t^4 + 10t^3 and the twelve edge gradients of Perlin 2002 ("Improving noise").
// Differs: an integer hash stands in for the permutation table, which needs no memory and takes a
// seed; the analytic gradient comes along, for bump mapping.

// A well-mixed 32-bit value per cell and seed: multiply and xorshift, the constants of the murmur3
// finaliser (Appleby 2011) and of Teschner et al. 2003 for the cell. The lattice repeats every 65536
// cells, so that the corners on both sides of its seam are the same.
uint nacre_hash(ivec3 cell, int seed)
{
    uint h = uint(cell.x & 65535) * 73856093u ^ uint(cell.y & 65535) * 19349663u ^ uint(cell.z & 65535) * 83492791u ^ uint(seed) * 2654435769u;
    h = (h ^ (h >> 16u)) * 2246822507u;
    h = (h ^ (h >> 13u)) * 3266489909u;
    return h ^ (h >> 16u);
}

// One of the twelve vectors from a cube's centre to the middles of its edges.
vec3 nacre_edgeGradient(uint h)
{
    float a = (h & 1u) == 0u ? 1.0 : -1.0;
    float b = (h & 2u) == 0u ? 1.0 : -1.0;
    uint axis = (h >> 2u) % 3u;
    return axis == 0u ? vec3(0.0, a, b) : axis == 1u ? vec3(a, 0.0, b) : vec3(a, b, 0.0);
}

// The corner's gradient and, in w, its ramp at the offset from that corner.
vec4 nacre_cornerRamp(ivec3 cell, int seed, vec3 offset)
{
    vec3 gradient = nacre_edgeGradient(nacre_hash(cell, seed));
    return vec4(gradient, dot(gradient, offset));
}

// Noise of one octave at p: gradient in xyz, value in w, about -1 to 1.
// The cell of a distant point is taken into the lattice's period before it becomes an int.
vec4 nacre_noise(vec3 p, int seed)
{
    vec3 corner = floor(p);
    vec3 t = p - corner;
    ivec3 cell = ivec3(corner - 65536.0 * floor(corner / 65536.0));

    vec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    vec3 slope = 30.0 * t * t * (t * (t - 2.0) + 1.0);

    vec4 n000 = nacre_cornerRamp(cell, seed, t);
    vec4 n100 = nacre_cornerRamp(cell + ivec3(1, 0, 0), seed, t - vec3(1.0, 0.0, 0.0));
    vec4 n010 = nacre_cornerRamp(cell + ivec3(0, 1, 0), seed, t - vec3(0.0, 1.0, 0.0));
    vec4 n110 = nacre_cornerRamp(cell + ivec3(1, 1, 0), seed, t - vec3(1.0, 1.0, 0.0));
    vec4 n001 = nacre_cornerRamp(cell + ivec3(0, 0, 1), seed, t - vec3(0.0, 0.0, 1.0));
    vec4 n101 = nacre_cornerRamp(cell + ivec3(1, 0, 1), seed, t - vec3(1.0, 0.0, 1.0));
    vec4 n011 = nacre_cornerRamp(cell + ivec3(0, 1, 1), seed, t - vec3(0.0, 1.0, 1.0));
    vec4 n111 = nacre_cornerRamp(cell + ivec3(1, 1, 1), seed, t - vec3(1.0, 1.0, 1.0));

    // Three linear blends; each adds the slope of its own weight to the gradient.
    vec4 x00 = mix(n000, n100, fade.x), x10 = mix(n010, n110, fade.x);
    vec4 x01 = mix(n001, n101, fade.x), x11 = mix(n011, n111, fade.x);
    vec4 y0 = mix(x00, x10, fade.y), y1 = mix(x01, x11, fade.y);
    vec4 noise = mix(y0, y1, fade.z);

    float alongX = mix(mix(n100.w - n000.w, n110.w - n010.w, fade.y), mix(n101.w - n001.w, n111.w - n011.w, fade.y), fade.z);
    float alongY = mix(x10.w - x00.w, x11.w - x01.w, fade.z);
    float alongZ = y1.w - y0.w;
    noise.xyz += slope * vec3(alongX, alongY, alongZ);
    return noise;
}

// Octaves summed, each of twice the frequency and half the amplitude; gradient in xyz, value in w,
// scaled by the root of the sum of their squares: octaves are
// independent, so the spread does not depend on their count.
vec4 nacre_turbulence(vec3 p, int octaves, int seed)
{
    vec4 sum = vec4(0.0);
    float frequency = 1.0, amplitude = 1.0, total = 0.0;
    for (int octave = 0; octave < NACRE_MAX_OCTAVES; ++octave) {
        if (octave >= octaves) break;
        vec4 noise = nacre_noise(p * frequency, seed + octave);
        sum += vec4(noise.xyz * frequency, noise.w) * amplitude;
        total += amplitude * amplitude;
        frequency *= 2.0;
        amplitude *= 0.5;
    }
    return sum / sqrt(max(total, 1.0));
}

#endif

#endif
