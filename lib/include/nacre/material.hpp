#pragma once

#include <glm/vec3.hpp>

namespace nacre {

/// How the lower boundary's normal lies to the upper one (Granier & Heidrich 2003, Sec 3.2, 6.2).
/// The values are those of NACRE_LOWER_NORMAL_* in the shaders.
enum class LowerNormal {
    parallel = 0,     ///< The same normal.
    constant = 1,     ///< Turned by the deviation everywhere, towards the azimuth (Figures 3 and 5).
    independent = 2,  ///< Leans along the gradient of noise of its own.
    gradient = 3,     ///< Leans along the gradient of the thickness, as in bump mapping (Figure 4).
};

/// How the layer is computed. The values are those of NACRE_QUALITY_* in the shaders.
enum class Quality {
    paper = 0,     ///< As Granier & Heidrich print it: two beams, Schlick's Fresnel, three wavelengths.
    physical = 1,  ///< The same two lobes with a real film: exact Fresnel, internal bounces, spectral fringes.
};

/// What lies below the layer, for quality `physical`. (`paper` takes it as a perfect mirror.)
enum class Substrate {
    dielectric = 0,  ///< By substrateIndex.
    metal = 1,       ///< By substrateIndex and substrateAbsorption.
    f0 = 2,          ///< By substrateF0, a colour as game engines have it.
};

/// How high the lobes of quality `physical` are.
enum class Lobes {
    paper = 0,       ///< 1 at their peak, as the paper's: the look does not depend on the exponents.
    normalised = 1,  ///< Over their integral: energy is conserved, a smoother boundary shines brighter.
};

/// A transparent layer on an opaque object: what an artist sets. Plain data; any member may be set
/// in any order, `validate` names what does not fit. A dvec3 holds the channels R, G, B.
///
/// Units, ranges and effects stand in `parameters()`, which the README's table, the command-line
/// options and the messages of `validate` are made from. In brackets the paper's symbols.
///
/// The defaults are a film of crown glass (Schott N-BK7 at the three wavelengths) that varies
/// between 200 and 400 nm.
struct Material {
    Quality quality = Quality::paper;

    glm::dvec3 ior{1.5148, 1.5196, 1.5263};  ///< Index of the layer [r1(λ)].
    double iorOutside = 1.0;                 ///< Index outside [r0].
    glm::dvec3 wavelengthNm{645.0, 525.0, 445.0};

    double thicknessLeastNm = 200.0;  ///< Bounds of the layer's thickness [d]; equal: constant.
    double thicknessMostNm = 400.0;
    double noiseFrequency = 1.5;  ///< Features of the thickness per unit of object space.
    int noiseOctaves = 3;         ///< 0: no noise, the thickness is the middle of its bounds.
    int noiseSeed = 1;

    LowerNormal lowerNormal = LowerNormal::parallel;
    double deviationDegrees = 0.0;  ///< Angle between the two normals.
    double azimuthDegrees = 0.0;    ///< Direction of that tilt, from the tangent.

    double upperExponent = 90.0;  ///< Phong exponent of the upper boundary [e0].
    double lowerExponent = 170.0;  ///< Phong exponent of the lower boundary [e1].

    double specularWeight = 1.0;
    double diffuseWeight = 0.5;

    /// From here on for quality `physical` alone.
    Substrate substrate = Substrate::dielectric;
    glm::dvec3 substrateIndex{1.77, 1.77, 1.78};       ///< Sapphire; of a metal the real part n.
    glm::dvec3 substrateAbsorption{0.0};               ///< k of a metal.
    glm::dvec3 substrateF0{0.04};                      ///< Reflectance at normal incidence in air, linear.
    Lobes lobes = Lobes::paper;
    glm::dvec3 diffuseAlbedo{0.8};
};

}  // namespace nacre
