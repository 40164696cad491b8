// The library as it is: tilted lower boundary, an index per channel, diffuse.
struct bench_View {
    nacre_Material material;
    nacre_View view;
};

bench_View bench_view(bench_Point p)
{
    bench_View w;
    w.material = nacre_materialFromUniforms();
    w.view = nacre_view(w.material, nacre_Surface(p.normal, p.lowerNormal, p.thicknessUm), p.view);
    return w;
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    return nacre_light(w.material, w.view, l);
}
