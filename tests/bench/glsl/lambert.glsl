// Lambert, the least that a diffuse part costs, for a normal of any length as the library takes it; weight and colour
// from the block, as one uniform.
struct bench_View {
    vec3 normal;
};

bench_View bench_view(bench_Point p)
{
    return bench_View(normalize(p.normal));
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    return nacre_packed[0].nacre_u_diffuse * clamp(dot(w.normal, l), 0.0, 1.0);
}
