// nacre's film: the whole of view and light, with the film in the block and lobes that are 1 everywhere.
vec3 bench_film(bench_Film f)
{
    float sine = sqrt((1.0 - f.cosTheta) * (1.0 + f.cosTheta));
    bench_Point p;
    p.position = vec3(0.0);
    p.normal = p.lowerNormal = vec3(0.0, 0.0, 1.0);
    p.tangent = vec3(1.0, 0.0, 0.0);
    p.toViewer = p.view = vec3(sine, 0.0, f.cosTheta);
    p.thicknessUm = f.thicknessUm;
    return bench_light(p, bench_view(p), vec3(-sine, 0.0, f.cosTheta)) / f.cosTheta;
}
