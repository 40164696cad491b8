// The simplest use of the model: parallel boundaries, one index for all channels, no diffuse. Scalars
// as far as the phase, in the library's stable forms.
struct bench_View {
    nacre_Material material;
    float cosTheta;
    float cosRefracted;
    float sqrtTransmittance;
    nacre_Path path;
};

float parallel_cosRefracted(nacre_Material m, float cosTheta)
{
    return sqrt(m.oneMinusEtaSquared.x + m.etaSquared.x * (cosTheta * cosTheta));
}

bench_View bench_view(bench_Point p)
{
    bench_View w;
    w.material = nacre_materialFromUniforms();
    nacre_Material m = w.material;
    w.cosTheta = clamp(dot(p.normal, p.view), 0.0, 1.0);
    w.cosRefracted = parallel_cosRefracted(m, w.cosTheta);
    w.sqrtTransmittance = sqrt((1.0 - m.normalReflectance.x) * nacre_transmittanceShape(w.cosRefracted));
    w.path = nacre_path(m.cyclesPerUm, m.cyclesPerUmTail, p.thicknessUm);
    return w;
}

vec3 bench_light(bench_Point p, bench_View w, vec3 l)
{
    nacre_Material m = w.material;
    float cosTheta = clamp(dot(p.normal, l), 0.0, 1.0);
    float cosRefracted = parallel_cosRefracted(m, cosTheta);

    vec3 across = l + p.view - p.normal * (cosTheta + w.cosTheta);
    float acrossSquared = dot(across, across);
    float along = cosTheta - w.cosTheta;
    float upper = 0.5 * (acrossSquared + along * along);
    float reflectance = nacre_reflectance(m.normalReflectance, cosTheta).x;
    float sqrtR = sqrt(reflectance) * nacre_powerOneMinus(upper, 0.5 * m.upperExponent);

    // cosTi - cosTo without cancellation: their squares differ by eta² (ci² - co²).
    float cosRefractedSum = cosRefracted + w.cosRefracted;
    float alongInside = m.etaSquared.x * along * (cosTheta + w.cosTheta) / cosRefractedSum;
    float lower = 0.5 * (m.etaSquared.x * acrossSquared + alongInside * alongInside);
    float transmittance = (1.0 - m.normalReflectance.x) * nacre_transmittanceShape(cosTheta);
    float sqrtT = sqrt(transmittance) * w.sqrtTransmittance * nacre_powerOneMinus(lower, 0.5 * m.lowerExponent);

    vec3 cosPhase = nacre_cosPhase(nacre_pathCycles(w.path, vec3(cosRefractedSum)));
    float isLit = cosTheta > 0.0 && w.cosTheta > 0.0 ? cosTheta : 0.0;
    return m.specularWeight * isLit * nacre_interference(vec3(sqrtR), vec3(sqrtT), cosPhase);
}
