#ifndef NACRE_UNIFORMS_GLSL
#define NACRE_UNIFORMS_GLSL

// The material as plain uniforms, for hosts without uniform buffers; nacre::Uniforms sets them. Those are declared
// that the shader has a use for, under the conditions of nacre_material.glsl.
#if NACRE_SPECULAR
uniform vec3 nacre_u_etaSquared;
uniform vec3 nacre_u_oneMinusEtaSquared;
uniform float nacre_u_upperExponent;
uniform float nacre_u_lowerExponent;
uniform float nacre_u_specularWeight;
#endif
#if NACRE_SPECULAR && (NACRE_TILT || NACRE_PHYSICAL)
uniform vec3 nacre_u_eta;
#endif
#if NACRE_SPECULAR && NACRE_PAPER
uniform vec3 nacre_u_normalReflectance;
#endif
#if NACRE_PAPER && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT || NACRE_SPECULAR && NACRE_PHYSICAL && NACRE_METAL && NACRE_FRINGE_TABLE
uniform vec3 nacre_u_cyclesPerUm;
#endif
#if NACRE_PAPER && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
uniform vec3 nacre_u_cyclesPerUmTail;
#endif
#if NACRE_SPECULAR && NACRE_PAPER && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
uniform vec3 nacre_u_pathHead;
uniform vec3 nacre_u_pathTail;
#endif
#if NACRE_DIFFUSE && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
uniform vec3 nacre_u_diffuse;
#endif
#if NACRE_DIFFUSE && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
uniform vec3 nacre_u_diffuseFringe;
uniform float nacre_u_diffuseWeight;
#endif
#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE
uniform float nacre_u_thicknessLeastUm;
uniform float nacre_u_thicknessMostUm;
#endif
#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE || NACRE_LOWER_NORMAL >= NACRE_LOWER_NORMAL_INDEPENDENT
uniform float nacre_u_noiseFrequency;
uniform int nacre_u_noiseOctaves;
uniform int nacre_u_noiseSeed;
#endif
#if NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_ANY
uniform int nacre_u_lowerNormal;
#endif
#if NACRE_LOWER_NORMAL != NACRE_LOWER_NORMAL_PARALLEL
uniform float nacre_u_deviationCos;
uniform float nacre_u_deviationSin;
uniform float nacre_u_azimuthCos;
uniform float nacre_u_azimuthSin;
#endif
#if NACRE_PHYSICAL && (NACRE_SPECULAR || NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT)
uniform vec3 nacre_u_index;
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
uniform float nacre_u_thicknessUm;
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR
uniform vec3 nacre_u_substrateReal;
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_METAL
uniform vec3 nacre_u_substrateImaginary;
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_METAL && NACRE_SAMPLER_FREE
uniform int nacre_u_substrate;
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_NORMALISED
uniform float nacre_u_upperScale;
uniform float nacre_u_lowerScale;
uniform int nacre_u_lobes;
#endif
#if NACRE_PHYSICAL && NACRE_DIFFUSE && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
uniform vec3 nacre_u_diffuseAlbedo;
#endif
#if NACRE_PAPER && NACRE_PHYSICAL
uniform int nacre_u_quality;
#endif

#endif
