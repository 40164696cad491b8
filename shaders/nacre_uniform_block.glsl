#ifndef NACRE_UNIFORM_BLOCK_GLSL
#define NACRE_UNIFORM_BLOCK_GLSL

// The material as one std140 block, nacre::Block on the host. Either this file or
// nacre_uniforms.glsl declares the names that nacre_material_from_uniforms.glsl reads.
layout(std140) uniform nacre_Block {
    vec3 nacre_u_eta;
    float nacre_u_upperExponent;
    vec3 nacre_u_etaSquared;
    float nacre_u_lowerExponent;
    vec3 nacre_u_oneMinusEtaSquared;
    float nacre_u_specularWeight;
    vec3 nacre_u_normalReflectance;
    float nacre_u_diffuseWeight;
    vec3 nacre_u_cyclesPerUm;
    float nacre_u_thicknessLeastUm;
    vec3 nacre_u_cyclesPerUmTail;
    float nacre_u_thicknessMostUm;
    vec3 nacre_u_diffuseFringe;
    float nacre_u_noiseFrequency;
    float nacre_u_deviationCos;
    float nacre_u_deviationSin;
    float nacre_u_azimuthCos;
    float nacre_u_azimuthSin;
    int nacre_u_noiseOctaves;
    int nacre_u_noiseSeed;
    int nacre_u_lowerNormal;
    int nacre_u_quality;
    vec3 nacre_u_index;
    float nacre_u_upperScale;
    vec3 nacre_u_substrateReal;
    float nacre_u_lowerScale;
    vec3 nacre_u_substrateImaginary;
    int nacre_u_substrate;
    vec3 nacre_u_diffuseAlbedo;
    int nacre_u_lobes;
};

#endif
