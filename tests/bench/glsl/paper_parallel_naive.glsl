// The paper as printed for parallel boundaries and one index: no diffuse.
struct bench_View {
    nacre_Material material;
    vec3 refracted;  // t_o
    float transmittance;
    float cosRefracted;
};

bench_View bench_view(bench_Point p)
{
    bench_View w;
    w.material = nacre_materialFromUniforms();
    float f = w.material.normalReflectance.x;
    w.refracted = refract(-p.view, p.normal, w.material.eta.x);
    w.cosRefracted = -dot(w.refracted, p.normal);
    w.transmittance = (1.0 - f) * (1.0 - pow(1.0 - w.cosRefracted, 5.0));
    return w;
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    nacre_Material m = w.material;
    float cosTheta = dot(p.normal, l);
    if (cosTheta <= 0.0) return vec3(0.0);

    float f = m.normalReflectance.x;
    float reflectance = f + (1.0 - f) * pow(1.0 - cosTheta, 5.0);
    float R = reflectance * pow(max(dot(reflect(-l, p.normal), p.view), 0.0), m.upperExponent);

    vec3 refracted = refract(-l, p.normal, m.eta.x);
    float lobe = dot(reflect(refracted, p.normal), -w.refracted);
    float T = (1.0 - reflectance) * w.transmittance * pow(max(lobe, 0.0), m.lowerExponent);

    float cosRefracted = -dot(refracted, p.normal);
    vec3 phase = 3.14159265 * m.cyclesPerUm * p.thicknessUm * (cosRefracted + w.cosRefracted);
    return m.specularWeight * (R + T + 2.0 * cos(2.0 * phase) * sqrt(R * T)) * cosTheta;
}
