#pragma once

#include <cmath>

#include <glm/glm.hpp>

#include <nacre/material.hpp>

// The double-precision twin of shaders/: the same functions with the same names in the same order, a
// file of one for a file of the other. The shaders say where each formula comes from; here stands
// only what differs in double precision.
namespace nacre::model {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

struct Material {
    dvec3 eta;
    dvec3 etaSquared;
    dvec3 oneMinusEtaSquared;
    dvec3 normalReflectance;
    dvec3 cyclesPerUm;
    dvec3 diffuseFringe;

    double upperExponent;
    double lowerExponent;
    double specularWeight;
    double diffuseWeight;

    double thicknessLeastUm;
    double thicknessMostUm;
    double noiseFrequency;
    int noiseOctaves;
    int noiseSeed;

    int lowerNormal;
    dvec3 index;
    dvec3 substrateReal;
    dvec3 substrateImaginary;
    dvec3 diffuseAlbedo;
    double upperScale;
    double lowerScale;
    int lobes;
    int substrate;
    int quality;

    double deviationCos;
    double deviationSin;
    double azimuthCos;
    double azimuthSin;
};

struct Surface {
    dvec3 upperNormal;
    dvec3 lowerNormal;
    double thicknessUm;
};

/// Whether the layer's noise does anything at all.
bool hasNoise(const nacre::Material& material);

/// What the shaders get from the host: everything that follows from a valid material alone.
Material derive(const nacre::Material& material);

}  // namespace nacre::model
