#ifndef NACRE_MATERIAL_GLSL
#define NACRE_MATERIAL_GLSL

// What depends on the material alone. The host computes it in double precision, `nacre::pack`
// (lib/src/block.cpp): subtracted here, 1 - eta^2 would lose up to 3e-2 near matched indices.
// A vec3 holds the channels R, G, B. Symbols of Granier & Heidrich 2003 in brackets.
struct nacre_Material {
    vec3 eta;                 // index outside over index of the layer [r0 / r1]
    vec3 etaSquared;
    vec3 oneMinusEtaSquared;  // (r1 - r0)(r1 + r0) / r1^2; negative below the outside index
    vec3 normalReflectance;   // [f, Eq 8]
    vec3 cyclesPerUm;         // index over wavelength [r1 / lambda], 1/um, rounded to 12 bits
    vec3 cyclesPerUmTail;     // what that rounding left out
    vec3 diffuseFringe;       // [2 sqrt(Td (1 - Td)), Eq 16]

    float upperExponent;      // Phong exponent of the boundary outside - layer [e0]
    float lowerExponent;      // Phong exponent of the boundary layer - object [e1]
    float specularWeight;
    float diffuseWeight;

    float thicknessLeastUm;   // bounds of the layer's thickness [d], um
    float thicknessMostUm;
    float noiseFrequency;     // features of the thickness per unit of length
    int noiseOctaves;
    int noiseSeed;

    int lowerNormal;          // one of NACRE_LOWER_NORMAL_*, nacre_lower_normal.glsl
    // Quality `physical` alone.
    vec3 index;               // of the layer [r1]
    vec3 substrateReal;       // square of the index below over the layer's: real
    vec3 substrateImaginary;  // and imaginary part, 0 for a dielectric
    vec3 diffuseAlbedo;
    float upperScale;         // root of what normalises the upper lobe, (e0 + 2) / 2pi; 1: not normalised
    float lowerScale;         // the same of the lower lobe, without its eta^2
    int lobes;                // 1: normalised
    int substrate;            // one of NACRE_SUBSTRATE_*
    int quality;              // one of NACRE_QUALITY_*

    float deviationCos;       // of the angle between the boundaries' normals
    float deviationSin;
    float azimuthCos;         // of the direction of that tilt, from the tangent
    float azimuthSin;
};

// What a shaded point adds: the local configuration of Sec 3.2, Figure 1.
struct nacre_Surface {
    vec3 upperNormal;   // outwards, any length but 0 [n0]
    vec3 lowerNormal;   // outwards, any length but 0 [n1]
    float thicknessUm;  // [d]
};

#endif
