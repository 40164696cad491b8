// The library's shader for the candidate's features. The point's thickness and lower normal stand for maps.
#if NACRE_FRINGE_TABLE && NACRE_PHYSICAL
uniform sampler2D bench_fringeTable;
#define BENCH_FRINGES , bench_fringeTable
#else
#define BENCH_FRINGES
#endif

struct bench_View {
    nacre_Material material;
    nacre_Shading shading;
};

bench_View bench_view(bench_Point p)
{
    bench_View w;
    w.material = nacre_materialFromUniforms();
#if NACRE_THICKNESS == NACRE_THICKNESS_MAP
    nacre_Surface s = nacre_Surface(p.normal, p.lowerNormal, p.thicknessUm);
#else
    nacre_Surface s = nacre_surface(w.material, p.normal, vec4(p.tangent, 1.0), p.position, mat3(1.0));
#endif
    w.shading = nacre_shading(w.material, s, p.view BENCH_FRINGES);
    return w;
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    return nacre_shade(w.material, w.shading, l BENCH_FRINGES);
}
