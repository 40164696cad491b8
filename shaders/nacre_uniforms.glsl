#ifndef NACRE_UNIFORMS_GLSL
#define NACRE_UNIFORMS_GLSL

// The material as plain uniforms, for hosts without uniform buffers; nacre::Uniforms sets them.
// Either this file or nacre_uniform_block.glsl declares the names that
// nacre_material_from_uniforms.glsl reads.
uniform vec3 nacre_u_eta;
uniform float nacre_u_upperExponent;
uniform vec3 nacre_u_etaSquared;
uniform float nacre_u_lowerExponent;
uniform vec3 nacre_u_oneMinusEtaSquared;
uniform float nacre_u_specularWeight;
uniform vec3 nacre_u_normalReflectance;
uniform float nacre_u_diffuseWeight;
uniform vec3 nacre_u_cyclesPerUm;
uniform float nacre_u_thicknessLeastUm;
uniform vec3 nacre_u_cyclesPerUmTail;
uniform float nacre_u_thicknessMostUm;
uniform vec3 nacre_u_diffuseFringe;
uniform float nacre_u_noiseFrequency;
uniform float nacre_u_deviationCos;
uniform float nacre_u_deviationSin;
uniform float nacre_u_azimuthCos;
uniform float nacre_u_azimuthSin;
uniform int nacre_u_noiseOctaves;
uniform int nacre_u_noiseSeed;
uniform int nacre_u_lowerNormal;
uniform int nacre_u_quality;
uniform vec3 nacre_u_index;
uniform float nacre_u_upperScale;
uniform vec3 nacre_u_substrateReal;
uniform float nacre_u_lowerScale;
uniform vec3 nacre_u_substrateImaginary;
uniform int nacre_u_substrate;
uniform vec3 nacre_u_diffuseAlbedo;
uniform int nacre_u_lobes;

#endif
