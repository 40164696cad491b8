#ifndef NACRE_MATERIAL_FROM_UNIFORMS_GLSL
#define NACRE_MATERIAL_FROM_UNIFORMS_GLSL

// The only functions that read uniforms: all others take values. Of three equal indices the first component is
// taken, nacre_Channels being a float then. The conditions are those of nacre_material.glsl.

#ifdef NACRE_UNIFORM_BLOCK_GLSL
#define NACRE_MEMBER(name) nacre_packed[index].name
// One of the block's materials; the index may differ by draw or by pixel.
nacre_Material nacre_material(int index)
#else
#define NACRE_MEMBER(name) name
nacre_Material nacre_materialFromUniforms()
#endif
{
    nacre_Material m;
#if NACRE_SPECULAR
    m.etaSquared = nacre_Channels(NACRE_MEMBER(nacre_u_etaSquared));
    m.oneMinusEtaSquared = nacre_Channels(NACRE_MEMBER(nacre_u_oneMinusEtaSquared));
    m.upperExponent = NACRE_MEMBER(nacre_u_upperExponent);
    m.lowerExponent = NACRE_MEMBER(nacre_u_lowerExponent);
    m.specularWeight = NACRE_MEMBER(nacre_u_specularWeight);
#endif
#if NACRE_SPECULAR && (NACRE_TILT || NACRE_PHYSICAL)
    m.eta = nacre_Channels(NACRE_MEMBER(nacre_u_eta));
#endif
#if NACRE_SPECULAR && NACRE_PAPER
    m.normalReflectance = nacre_Channels(NACRE_MEMBER(nacre_u_normalReflectance));
#endif
#if NACRE_PAPER && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT || NACRE_SPECULAR && NACRE_PHYSICAL && NACRE_METAL && NACRE_FRINGE_TABLE
    m.cyclesPerUm = NACRE_MEMBER(nacre_u_cyclesPerUm);
#endif
#if NACRE_PAPER && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
    m.cyclesPerUmTail = NACRE_MEMBER(nacre_u_cyclesPerUmTail);
#endif
#if NACRE_SPECULAR && NACRE_PAPER && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    m.pathHead = NACRE_MEMBER(nacre_u_pathHead);
    m.pathTail = NACRE_MEMBER(nacre_u_pathTail);
#endif
#if NACRE_DIFFUSE && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    m.diffuse = NACRE_MEMBER(nacre_u_diffuse);
#endif
#if NACRE_DIFFUSE && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
    m.diffuseFringe = nacre_Channels(NACRE_MEMBER(nacre_u_diffuseFringe));
    m.diffuseWeight = NACRE_MEMBER(nacre_u_diffuseWeight);
#endif
#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE
    m.thicknessLeastUm = NACRE_MEMBER(nacre_u_thicknessLeastUm);
    m.thicknessMostUm = NACRE_MEMBER(nacre_u_thicknessMostUm);
#endif
#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE || NACRE_LOWER_NORMAL >= NACRE_LOWER_NORMAL_INDEPENDENT
    m.noiseFrequency = NACRE_MEMBER(nacre_u_noiseFrequency);
    m.noiseOctaves = NACRE_MEMBER(nacre_u_noiseOctaves);
    m.noiseSeed = NACRE_MEMBER(nacre_u_noiseSeed);
#endif
#if NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_ANY
    m.lowerNormal = NACRE_MEMBER(nacre_u_lowerNormal);
#endif
#if NACRE_LOWER_NORMAL != NACRE_LOWER_NORMAL_PARALLEL
    m.deviationCos = NACRE_MEMBER(nacre_u_deviationCos);
    m.deviationSin = NACRE_MEMBER(nacre_u_deviationSin);
    m.azimuthCos = NACRE_MEMBER(nacre_u_azimuthCos);
    m.azimuthSin = NACRE_MEMBER(nacre_u_azimuthSin);
#endif
#if NACRE_PHYSICAL && (NACRE_SPECULAR || NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT)
    m.index = nacre_Channels(NACRE_MEMBER(nacre_u_index));
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    m.thicknessUm = NACRE_MEMBER(nacre_u_thicknessUm);
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR
    m.substrateReal = NACRE_MEMBER(nacre_u_substrateReal);
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_METAL
    m.substrateImaginary = NACRE_MEMBER(nacre_u_substrateImaginary);
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_METAL && NACRE_SAMPLER_FREE
    m.substrate = NACRE_MEMBER(nacre_u_substrate);
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_NORMALISED
    m.upperScale = NACRE_MEMBER(nacre_u_upperScale);
    m.lowerScale = NACRE_MEMBER(nacre_u_lowerScale);
    m.lobes = NACRE_MEMBER(nacre_u_lobes);
#endif
#if NACRE_PHYSICAL && NACRE_DIFFUSE && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
    m.diffuseAlbedo = NACRE_MEMBER(nacre_u_diffuseAlbedo);
#endif
#if NACRE_PAPER && NACRE_PHYSICAL
    m.quality = NACRE_MEMBER(nacre_u_quality);
#endif
    return m;
}

#ifdef NACRE_UNIFORM_BLOCK_GLSL
nacre_Material nacre_materialFromUniforms()
{
    return nacre_material(0);
}
#endif

#endif
