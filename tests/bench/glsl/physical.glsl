// Quality physical. BENCH_FILM_ONLY: film and lobes, no diffuse part; BENCH_TABLE: fringes from the texture.
#if BENCH_TABLE
uniform sampler2D bench_fringeTable;
#define BENCH_FRINGES , bench_fringeTable
#else
#define BENCH_FRINGES
#endif

struct bench_View {
    nacre_Material material;
    nacre_PhysicalView view;
};

bench_View bench_view(bench_Point p)
{
    bench_View w;
    w.material = nacre_materialFromUniforms();
    nacre_Surface s = nacre_Surface(p.normal, p.lowerNormal, p.thicknessUm);
#if BENCH_FILM_ONLY
    w.view = nacre_physicalViewWithoutDiffuse(w.material, s, p.view);
#else
    w.view = nacre_physicalView(w.material, s, p.view BENCH_FRINGES);
#endif
    return w;
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    return nacre_physicalLight(w.material, w.view, l BENCH_FRINGES);
}
