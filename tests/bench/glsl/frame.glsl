// What every candidate is given per pixel and light. All of it varies over the picture, so that no
// compiler can take a candidate's work out of the pixel.
layout(std140) uniform bench_Frame {
    vec2 bench_pixelSize;  // one over the picture's size
    int bench_lightCount;
    vec4 bench_lights[BENCH_MAX_LIGHTS];  // positions
};

struct bench_Point {
    vec3 position;
    vec3 normal;       // unit
    vec3 tangent;      // unit, across the normal
    vec3 lowerNormal;  // unit, leans away from the normal as a normal map has it, 7 degrees at most
    vec3 toViewer;     // any length
    vec3 view;         // unit
    float thicknessUm; // 0.1 to 0.5
};

bench_Point bench_point()
{
    bench_Point p;
    vec2 at = gl_FragCoord.xy * bench_pixelSize;
    vec2 across = 2.0 * at - 1.0;
    p.position = vec3(across, 0.3 * (1.0 - dot(across, across)));
    p.normal = normalize(vec3(0.6 * across, 1.0));
    p.tangent = normalize(vec3(p.normal.z, 0.0, -p.normal.x));
    vec3 bump = fract(vec3(at * vec2(13.0, 17.0), at.x * 3.0 + at.y * 7.0));
    p.lowerNormal = normalize(p.normal + 0.17 * ((bump.x - 0.5) * p.tangent + (bump.y - 0.5) * cross(p.normal, p.tangent)));
    p.toViewer = vec3(0.3, -0.2, 3.0) - p.position;
    p.view = normalize(p.toViewer);
    p.thicknessUm = 0.1 + 0.4 * bump.z;
    return p;
}

vec3 bench_toLight(bench_Point p, int index)
{
    return normalize(bench_lights[index].xyz - p.position);
}

// Goes into the alpha of every candidate, flat included: nothing that bench_point makes is left out
// where a candidate does not read it, so the increment over flat is the candidate's own.
float bench_inputs(bench_Point p)
{
    return dot(p.normal + p.lowerNormal, p.tangent + p.view) + p.thicknessUm;
}
