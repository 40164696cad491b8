#ifndef NACRE_MATERIAL_FROM_UNIFORMS_GLSL
#define NACRE_MATERIAL_FROM_UNIFORMS_GLSL

// The only function that reads uniforms: all others take values.
nacre_Material nacre_materialFromUniforms()
{
    nacre_Material m;
    m.eta = nacre_u_eta;
    m.upperExponent = nacre_u_upperExponent;
    m.etaSquared = nacre_u_etaSquared;
    m.lowerExponent = nacre_u_lowerExponent;
    m.oneMinusEtaSquared = nacre_u_oneMinusEtaSquared;
    m.specularWeight = nacre_u_specularWeight;
    m.normalReflectance = nacre_u_normalReflectance;
    m.diffuseWeight = nacre_u_diffuseWeight;
    m.cyclesPerUm = nacre_u_cyclesPerUm;
    m.thicknessLeastUm = nacre_u_thicknessLeastUm;
    m.cyclesPerUmTail = nacre_u_cyclesPerUmTail;
    m.thicknessMostUm = nacre_u_thicknessMostUm;
    m.diffuseFringe = nacre_u_diffuseFringe;
    m.noiseFrequency = nacre_u_noiseFrequency;
    m.deviationCos = nacre_u_deviationCos;
    m.deviationSin = nacre_u_deviationSin;
    m.azimuthCos = nacre_u_azimuthCos;
    m.azimuthSin = nacre_u_azimuthSin;
    m.noiseOctaves = nacre_u_noiseOctaves;
    m.noiseSeed = nacre_u_noiseSeed;
    m.lowerNormal = nacre_u_lowerNormal;
    return m;
}

#endif
