#ifndef NACRE_MATERIAL_FROM_UNIFORMS_GLSL
#define NACRE_MATERIAL_FROM_UNIFORMS_GLSL

// The material with the red channel's indices in all three. The wavelengths stay as they are. A compiler
// that sees three times the same computes it once.
nacre_Material nacre_withOneIndex(nacre_Material m)
{
    m.eta = m.eta.xxx;
    m.etaSquared = m.etaSquared.xxx;
    m.oneMinusEtaSquared = m.oneMinusEtaSquared.xxx;
    m.normalReflectance = m.normalReflectance.xxx;
    m.diffuseFringe = m.diffuseFringe.xxx;
    m.index = m.index.xxx;
    m.substrateReal = m.substrateReal.xxx;
    m.substrateImaginary = m.substrateImaginary.xxx;
    return m;
}

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
    m.quality = nacre_u_quality;
    m.index = nacre_u_index;
    m.upperScale = nacre_u_upperScale;
    m.substrateReal = nacre_u_substrateReal;
    m.lowerScale = nacre_u_lowerScale;
    m.substrateImaginary = nacre_u_substrateImaginary;
    m.substrate = nacre_u_substrate;
    m.diffuseAlbedo = nacre_u_diffuseAlbedo;
    m.lobes = nacre_u_lobes;
#if NACRE_METAL == 0
    m.substrate = NACRE_SUBSTRATE_DIELECTRIC;
#endif
#if NACRE_NORMALISED == 0
    m.lobes = 0;
#endif
#if NACRE_DISPERSION == 0
    m = nacre_withOneIndex(m);
#endif
    return m;
}

#endif
