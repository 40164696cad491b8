// three.js's film as lights_fragment_begin calls it. What lies below is an F0 there: specularColor, from
// `ior`, at metalness 0, the colour at metalness 1. Who sets them takes the bare surface's reflectance in
// air, which for a metal is ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2).
vec3 bench_film(bench_Film f)
{
    vec3 kSquared = pow2(f.substrateImaginary);
    vec3 baseF0 = (pow2(f.substrateReal - 1.0) + kSquared) / (pow2(f.substrateReal + 1.0) + kSquared);
    // No thickness, no iridescence: the plain material's Fresnel.
    if (f.thicknessUm == 0.0) return F_Schlick(baseF0, 1.0, f.cosTheta);
    return evalIridescence(1.0, f.index, f.cosTheta, 1000.0 * f.thicknessUm, baseF0);
}
