// Phong 1975 and Lambert, as every renderer begins; exponent, weights and colours from the block.
struct bench_View {
    vec3 mirrored;
};

bench_View bench_view(bench_Point p)
{
    return bench_View(reflect(-p.view, p.normal));
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    float cosTheta = max(dot(p.normal, l), 0.0);
    float lobe = pow(max(dot(w.mirrored, l), 0.0), nacre_packed[0].nacre_u_upperExponent);
    return (nacre_packed[0].nacre_u_specularWeight * nacre_packed[0].nacre_u_normalReflectance * lobe + nacre_packed[0].nacre_u_diffuseWeight * nacre_packed[0].nacre_u_diffuseFringe) * cosTheta;
}
