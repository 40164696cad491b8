// MaterialX's closures with a thin film, evaluated per light as the shaders that it generates do.
// MATERIALX_FUNCTIONS stands for its library files, resolved.
//   BENCH_STANDARD_SURFACE 0  dielectric_bsdf alone
//   BENCH_STANDARD_SURFACE 1  what standard_surface.mtlx makes of a base with a film: conductor_bsdf mixed
//                             with dielectric_bsdf over a diffuse base, no coat, sheen or transmission
#define DIRECTIONAL_ALBEDO_METHOD 0
#define AIRY_FRESNEL_ITERATIONS 2

layout(std140) uniform bench_Material {
    vec3 tint;
    float weight;
    vec2 roughness;  // squared already, as mx_roughness_anisotropy hands it on
    float ior;
    float thinFilmIor;
    vec3 metalIor;
    float metalness;
    vec3 metalExtinction;
    float diffuseRoughness;
    vec3 baseColor;
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
    float thicknessNm = 1000.0 * p.thicknessUm;
    ClosureData closure = makeClosureData(CLOSURE_TYPE_REFLECTION, l, p.view, p.normal, p.position, 1.0);
    BSDF specular = BSDF(vec3(0.0), vec3(1.0));
    mx_dielectric_bsdf(closure, weight, tint, ior, roughness, false, thicknessNm, thinFilmIor, p.normal, p.tangent, 0, 0, specular);
#if BENCH_STANDARD_SURFACE
    BSDF diffuse = BSDF(vec3(0.0), vec3(1.0)), metal = diffuse, layered, surface;
    mx_oren_nayar_diffuse_bsdf(closure, weight, baseColor, diffuseRoughness, p.normal, false, diffuse);
    mx_conductor_bsdf(closure, weight, metalIor, metalExtinction, roughness, false, thicknessNm, thinFilmIor, p.normal, p.tangent, 0, metal);
    mx_layer_bsdf(closure, specular, diffuse, layered);
    mx_mix_bsdf(closure, metal, layered, metalness, surface);
    return surface.response;
#else
    return specular.response;
#endif
}
