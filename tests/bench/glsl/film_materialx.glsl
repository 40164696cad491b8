// MaterialX's film as dielectric_bsdf and conductor_bsdf call it, in the mirror direction.
vec3 bench_film(bench_Film f)
{
    float thicknessNm = 1000.0 * f.thicknessUm;
    FresnelData fd = f.substrateImaginary == vec3(0.0)
                         ? mx_init_fresnel_dielectric(f.substrateReal.x, thicknessNm, f.index)
                         : mx_init_fresnel_conductor(f.substrateReal, f.substrateImaginary, thicknessNm, f.index);
    return mx_compute_fresnel(f.cosTheta, fd);
}
