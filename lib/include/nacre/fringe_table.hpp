#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <nacre/result.hpp>

namespace nacre {

/// The colour space that quality `physical` renders to and the light that a film is seen in.
/// Default: linear Rec.709 (sRGB's primaries), equal-energy light adapted to the white.
struct FringeOptions {
    glm::dvec2 red{0.64, 0.33};  ///< CIE 1931 chromaticities (x, y) of the primaries
    glm::dvec2 green{0.30, 0.60};
    glm::dvec2 blue{0.15, 0.06};
    glm::dvec2 white{0.3127, 0.3290};  ///< and of the white, to which the light is adapted (Bradford): grey stays grey.
    /// Relative power of the light from 360 to 830 nm by 1 nm, 471 values; empty: the same everywhere.
    std::vector<double> light;
};

/// What a sensor makes of a film's fringes, all internal bounces summed, as a texture for the shaders
/// (nacre_fringe_table.glsl): computed in double precision from the CIE 1931 observer. The host makes the texture:
///
///     auto table = nacre::FringeTable::create();
///     glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, table->width, table->height, 0, GL_RGBA, GL_FLOAT, table->texels().data());
///     // GL_LINEAR for both filters, GL_CLAMP_TO_EDGE, no mipmaps
///
/// Every format that is filtered will do; one of eight bits costs as much and is seven times as far from the film.
class FringeTable {
public:
    static constexpr int width = 1024;       ///< Path differences from 0 to rangeUm, both included, in steps of their root.
    static constexpr int rows = 32;          ///< Of each phase: ratios from -1 to 1.
    static constexpr int phases = 4;         ///< Of the ratio, k π/4; a dielectric reads the first alone.
    static constexpr int height = rows * phases;
    static constexpr double rangeUm = 10.0;  ///< Beyond it fringes have less than 0.3 % of their contrast: 0 from there on.

    /// Errors: primaries without a gamut, a light of another length, negative or dark, curves so wild that a
    /// texel cannot hold them.
    static Result<FringeTable> create(const FringeOptions& options = {});

    /// RGBA in [0, 1], row after row: red, green, blue, and 1.
    const std::vector<float>& texels() const noexcept { return texels_; }
    /// F(x, q) as the shaders read it: linear between texels, in double precision.
    ///   pathUm  path difference x, µm, held to the table's range
    ///   ratio   |q| with its sign, -1 to 1
    ///   phase   the phase of q beside that sign, in steps of π/4, 0 to 3
    /// At ratio 0 this is the fringe C(x) itself.
    glm::dvec3 look(double pathUm, double ratio, int phase = 0) const noexcept;

private:
    std::vector<float> texels_;
};

}  // namespace nacre
