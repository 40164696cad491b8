#ifndef NACRE_UNIFORM_BLOCK_GLSL
#define NACRE_UNIFORM_BLOCK_GLSL

// Materials as an array in one std140 block, nacre::Block each on the host. The layout is the same for every shader,
// so that materials of different needs share a buffer. Either this file or nacre_uniforms.glsl has what
// nacre_material_from_uniforms.glsl reads.
struct nacre_Packed {
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
    vec3 nacre_u_diffuse;
    float nacre_u_thicknessUm;
    vec3 nacre_u_pathHead;
    float nacre_u_unused0;
    vec3 nacre_u_pathTail;
    float nacre_u_unused1;
};

#ifndef NACRE_BLOCK_LAYOUT
#define NACRE_BLOCK_LAYOUT layout(std140)
#endif
NACRE_BLOCK_LAYOUT uniform nacre_Block {
    nacre_Packed nacre_packed[NACRE_MATERIALS];
};

#endif
