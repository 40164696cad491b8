#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nacre/material.hpp>
#include <nacre/result.hpp>

namespace nacre {

/// Where a shader has the thickness of the layer from. The values are those of NACRE_THICKNESS_* in the shaders.
enum class ThicknessSource {
    constant = 0,  ///< A uniform; what follows from it is computed on the host.
    noise = 1,     ///< The material's noise, per pixel.
    map = 2,       ///< The host fills nacre_Surface itself, normals included.
};

/// What a shader can do about the lower normal. The first four are those of LowerNormal.
enum class LowerNormals { parallel = 0, constant = 1, independent = 2, gradient = 3, any = 4 };

/// Where quality `physical` has its fringes from.
enum class Fringes {
    table,        ///< The texture of FringeTable: closest to the film, one texture unit.
    samplerFree,  ///< Formulas, for Rec.709 alone.
    either,       ///< The shader has functions for both, its host takes its pick.
};

/// What a shader computes: the switches of nacre_config.glsl. The default is everything, each part in its
/// most accurate form.
struct Features {
    bool paper = true;     ///< Qualities: with both the material decides at run time.
    bool physical = true;
    bool specular = true;
    bool diffuse = true;
    bool dispersion = true;       ///< The layer's indices differ between channels.
    bool totalReflection = true;  ///< Some index of the layer is below the outside's.
    ThicknessSource thickness = ThicknessSource::noise;
    LowerNormals lowerNormals = LowerNormals::any;  ///< With a thickness map: parallel, or any for the host's own.

    bool substrateChannels = true;  ///< physical: what lies below differs between channels, or the layer does.
    bool metal = true;              ///< physical: it absorbs.
    bool normalised = true;         ///< physical: lobes may be normalised.
    Fringes fringes = Fringes::either;

    bool stableLobes = true;       ///< Forms; see nacre_config.glsl.
    bool splitPhase = true;
    bool polynomialCosine = true;

    int lights = 4;     ///< Most lights at once, of a shader with nacre_lights.glsl.
    int materials = 1;  ///< In the uniform block.
};

bool operator==(const Features& a, const Features& b) noexcept;
bool operator!=(const Features& a, const Features& b) noexcept;

/// What the shader will run on: which of two forms of a cosine is the cheaper.
enum class Machine {
    gpu,  ///< Has sines, logarithms and exponentials as instructions.
    cpu,  ///< llvmpipe, SwiftShader: polynomials are cheaper.
};

/// What the material alone does not tell.
struct FeatureOptions {
    /// Error of the final pixel that is accepted, in linear light, display white 1, for one light of radiance 1; over
    /// max(1, ρ) as everywhere. Default: a quarter of a step of eight bits. 0: the most accurate forms.
    double error = 0.25 / 255.0;
    Machine machine = Machine::gpu;
    Fringes fringes = Fringes::table;
    bool thicknessMap = false;    ///< The host fills nacre_Surface itself.
    bool lowerNormalMap = false;  ///< Then: with a lower normal of its own.
    int lights = 4;
};

/// The least that shades the material: a part that would change no pixel is left out, and each of the others
/// takes its cheapest form whose measured bound over the material's own range (lib/src/form_bounds.hpp)
/// stays within the error. An invalid material is an error, as in `pack`. Not canonical: parts that are idle here may wake
/// in a set's shader, see join.
Result<Features> featuresOf(const Material& material, const FeatureOptions& options = {});

/// A shader that serves the materials of both.
Features join(const Features& a, const Features& b) noexcept;

/// The same shader's features in their one canonical way: what has no part to act on is off.
Features canonical(const Features& features) noexcept;

/// A number per variant, for a cache of programs: equal for equal shaders, of canonical features' own.
std::uint64_t key(const Features& features) noexcept;

/// The features as lines for people, those that cost something: "a lower boundary that leans: one lobe per tilt".
std::vector<std::string> describe(const Features& features);

}  // namespace nacre
