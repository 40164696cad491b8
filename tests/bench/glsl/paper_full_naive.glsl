// The paper as printed, for tilted boundaries and an index per channel: refracted vectors, powers of
// dot products, the cosine of the phase, the root of the product. What depends on the view alone is
// computed once, as in the library.
struct bench_View {
    nacre_Material material;
    vec3 refracted[3];   // t_o
    vec3 transmittance;  // Eq 9
    vec3 cosRefracted;
    vec3 diffuse;        // Eq 16
};

vec3 naive_schlick(vec3 f, float cosTheta)
{
    return f + (1.0 - f) * pow(1.0 - cosTheta, 5.0);
}

bench_View bench_view(bench_Point p)
{
    bench_View w;
    w.material = nacre_materialFromUniforms();
    nacre_Material m = w.material;
    for (int k = 0; k < 3; ++k) {
        w.refracted[k] = refract(-p.view, p.normal, m.eta[k]);
        w.cosRefracted[k] = -dot(w.refracted[k], p.normal);
        w.transmittance[k] = (1.0 - m.normalReflectance[k]) * (1.0 - pow(1.0 - w.cosRefracted[k], 5.0));
    }
    vec3 inside = (20.0 / 21.0) * (1.0 - m.normalReflectance);
    w.diffuse = 1.0 + 2.0 * cos(12.5663706 * m.cyclesPerUm * p.thicknessUm) * sqrt(inside * (1.0 - inside));
    return w;
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    nacre_Material m = w.material;
    float cosTheta = dot(p.normal, l);
    if (cosTheta <= 0.0) return vec3(0.0);

    vec3 reflectance = naive_schlick(m.normalReflectance, cosTheta);
    vec3 R = reflectance * pow(max(dot(reflect(-l, p.normal), p.view), 0.0), m.upperExponent);

    vec3 T, cosRefracted;
    for (int k = 0; k < 3; ++k) {
        vec3 refracted = refract(-l, p.normal, m.eta[k]);
        cosRefracted[k] = -dot(refracted, p.normal);
        float lobe = dot(reflect(refracted, p.lowerNormal), -w.refracted[k]);
        bool isNull = dot(refracted, p.lowerNormal) >= 0.0 || dot(w.refracted[k], p.lowerNormal) >= 0.0 || lobe <= 0.0;
        T[k] = isNull ? 0.0 : (1.0 - reflectance[k]) * w.transmittance[k] * pow(lobe, m.lowerExponent);
    }
    vec3 phase = 3.14159265 * m.cyclesPerUm * p.thicknessUm * (cosRefracted + w.cosRefracted);
    vec3 rho = R + T + 2.0 * cos(2.0 * phase) * sqrt(R * T);
    return (m.specularWeight * rho + m.diffuseWeight * w.diffuse) * cosTheta;
}
