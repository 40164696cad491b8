#ifndef NACRE_MATERIAL_GLSL
#define NACRE_MATERIAL_GLSL

// What depends on the material alone. The host computes it in double precision, `nacre::pack`
// (lib/src/block.cpp): subtracted here, 1 - eta^2 would lose up to 3e-2 near matched indices.
// nacre_Channels: R, G, B, or one for the three. Symbols of Granier & Heidrich 2003 in brackets.
// A shader has the members that its switches leave it something to do with; the conditions are
// those of nacre_uniforms.glsl.
struct nacre_Material {
#if NACRE_SPECULAR
    nacre_Channels etaSquared;          // square of the index outside over the layer's
    nacre_Channels oneMinusEtaSquared;  // (r1 - r0)(r1 + r0) / r1^2; negative below the outside index
    float upperExponent;                // Phong exponent of the boundary outside - layer [e0]
    float lowerExponent;                // Phong exponent of the boundary layer - object [e1]
    float specularWeight;
#endif
#if NACRE_SPECULAR && (NACRE_TILT || NACRE_PHYSICAL)
    nacre_Channels eta;                 // index outside over index of the layer [r0 / r1]
#endif
#if NACRE_SPECULAR && NACRE_PAPER
    nacre_Channels normalReflectance;   // [f, Eq 8]
#endif
#if NACRE_PAPER && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT || NACRE_SPECULAR && NACRE_PHYSICAL && NACRE_METAL && NACRE_FRINGE_TABLE
    vec3 cyclesPerUm;                   // index over wavelength [r1 / lambda], 1/um, rounded to 12 bits
#endif
#if NACRE_PAPER && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
    vec3 cyclesPerUmTail;               // what that rounding left out
#endif
#if NACRE_SPECULAR && NACRE_PAPER && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    vec3 pathHead;                      // the layer's thickness in wavelengths [r1 d / lambda], nacre_Path
    vec3 pathTail;
#endif
#if NACRE_DIFFUSE && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    vec3 diffuse;                       // the diffuse part and its weight [rho_d, Eq 16]
#endif
#if NACRE_DIFFUSE && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
    nacre_Channels diffuseFringe;       // [2 sqrt(Td (1 - Td)), Eq 16]
    float diffuseWeight;
#endif

#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE
    float thicknessLeastUm;             // bounds of the layer's thickness [d], um
    float thicknessMostUm;
#endif
#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE || NACRE_LOWER_NORMAL >= NACRE_LOWER_NORMAL_INDEPENDENT
    float noiseFrequency;               // features of the thickness per unit of length
    int noiseOctaves;
    int noiseSeed;
#endif
#if NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_ANY
    int lowerNormal;                    // one of NACRE_LOWER_NORMAL_*, nacre_lower_normal.glsl
#endif
#if NACRE_LOWER_NORMAL != NACRE_LOWER_NORMAL_PARALLEL
    float deviationCos;                 // of the angle between the boundaries' normals
    float deviationSin;
    float azimuthCos;                   // of the direction of that tilt, from the tangent
    float azimuthSin;
#endif

    // Quality `physical` alone.
#if NACRE_PHYSICAL && (NACRE_SPECULAR || NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT)
    nacre_Channels index;               // of the layer [r1]
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_THICKNESS == NACRE_THICKNESS_CONSTANT
    float thicknessUm;                  // [d]
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR
    vec3 substrateReal;                 // square of the index below over the layer's: real
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_METAL
    vec3 substrateImaginary;            // and imaginary part, 0 for a dielectric
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_METAL && NACRE_SAMPLER_FREE
    int substrate;                      // one of NACRE_SUBSTRATE_*
#endif
#if NACRE_PHYSICAL && NACRE_SPECULAR && NACRE_NORMALISED
    float upperScale;                   // root of what normalises the upper lobe, (e0 + 2) / 2pi; 1: not normalised
    float lowerScale;                   // the same of the lower lobe, without its eta^2
    int lobes;                          // 1: normalised
#endif
#if NACRE_PHYSICAL && NACRE_DIFFUSE && NACRE_THICKNESS != NACRE_THICKNESS_CONSTANT
    vec3 diffuseAlbedo;
#endif
#if NACRE_PAPER && NACRE_PHYSICAL
    int quality;                        // one of NACRE_QUALITY_*
#endif
};

// What a shaded point adds: the local configuration of Sec 3.2, Figure 1.
struct nacre_Surface {
    vec3 upperNormal;   // outwards, any length but 0 [n0]
    vec3 lowerNormal;   // outwards, any length but 0 [n1]
    float thicknessUm;  // [d]
};

#endif
