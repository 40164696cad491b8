#pragma once

#include <cstdint>

#include <nacre/fringe_table.hpp>
#include <nacre/material.hpp>
#include <nacre/result.hpp>

namespace nacre {

/// A material in the uniform block `nacre_Block` (shaders/nacre_uniform_block.glsl), byte for byte as std140 lays it
/// out: copy it into a uniform buffer, an array of them for many materials. It holds what follows from the material
/// alone, computed in double precision; the meaning of each member stands at `nacre_Material` (shaders/nacre_material.glsl).
/// 256 bytes, the alignment that any driver asks of a buffer's range.
struct Block {
    float eta[3];
    float upperExponent;
    float etaSquared[3];
    float lowerExponent;
    float oneMinusEtaSquared[3];
    float specularWeight;
    float normalReflectance[3];
    float diffuseWeight;
    float cyclesPerUm[3];
    float thicknessLeastUm;
    float cyclesPerUmTail[3];
    float thicknessMostUm;
    float diffuseFringe[3];
    float noiseFrequency;
    float deviationCos;
    float deviationSin;
    float azimuthCos;
    float azimuthSin;
    std::int32_t noiseOctaves;
    std::int32_t noiseSeed;
    std::int32_t lowerNormal;
    std::int32_t quality;
    float index[3];
    float upperScale;
    float substrateReal[3];
    float lowerScale;
    float substrateImaginary[3];
    std::int32_t substrate;
    float diffuseAlbedo[3];
    std::int32_t lobes;
    float diffuse[3];
    float thicknessUm;
    float pathHead[3];
    float unused0;
    float pathTail[3];
    float unused1;
};
static_assert(sizeof(Block) == 256, "std140: sixteen rows of four words, none of them padded by the compiler");

/// The block of a material; the first fault that `validate` finds otherwise, never a NaN.
/// Allocates nothing where the material is valid.
///   fringeTable  where shaders read one: constant diffuse parts of quality `physical` are then of its colours
Result<Block> pack(const Material& material, const FringeTable* fringeTable = nullptr);

}  // namespace nacre
