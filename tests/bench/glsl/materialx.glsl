// MaterialX's dielectric_bsdf with a thin film, evaluated per light as the shaders that it generates
// do. MATERIALX_FUNCTIONS stands for its library files, resolved.
#define DIRECTIONAL_ALBEDO_METHOD 0
#define AIRY_FRESNEL_ITERATIONS 2

layout(std140) uniform bench_Material {
    vec3 tint;
    float weight;
    vec2 roughness;  // squared already, as mx_roughness_anisotropy hands it on
    float ior;
    float thinFilmIor;
};

struct BSDF {
    vec3 response;
    vec3 throughput;
};

MATERIALX_FUNCTIONS

struct bench_View {
    float unused;
};

bench_View bench_view(bench_Point p)
{
    return bench_View(0.0);
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    ClosureData closure = makeClosureData(CLOSURE_TYPE_REFLECTION, l, p.view, p.normal, p.position, 1.0);
    BSDF bsdf = BSDF(vec3(0.0), vec3(1.0));
    mx_dielectric_bsdf(closure, weight, tint, ior, roughness, false, 1000.0 * p.thicknessUm, thinFilmIor, p.normal, p.tangent, 0,
                       0, bsdf);
    return bsdf.response;
}
