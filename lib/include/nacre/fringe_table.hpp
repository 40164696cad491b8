#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

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

/// What a sensor makes of fringes, as a texture for the shaders (nacre_fringe_table.glsl): computed in
/// double precision from the CIE 1931 observer. The host makes the texture:
///
///     auto table = nacre::FringeTable::create();
///     glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, table->width, table->height, 0, GL_RGBA, GL_UNSIGNED_BYTE, table->bytes().data());
///     // GL_LINEAR for both filters, GL_CLAMP_TO_EDGE along the width, no mipmaps
///
/// or in GL_RGBA16, GL_RGBA16F or GL_RGBA32F from texels(): every format that is filtered will do.
class FringeTable {
public:
    static constexpr int width = 1024;       ///< Path differences from 0 to rangeUm, both included.
    static constexpr int height = 2;         ///< Rows of Row.
    static constexpr double rangeUm = 10.0;  ///< Beyond it fringes have less than 0.3 % of their contrast: 0 from there on.

    enum class Row { cosine = 0, sine = 1 };

    /// Errors: primaries without a gamut, a light of another length, negative or dark, curves so wild that a
    /// texel cannot hold them.
    static Result<FringeTable> create(const FringeOptions& options = {});

    /// RGBA in [0, 1], row after row: red, green, blue, and the contrast that the luminance has left.
    const std::vector<float>& texels() const noexcept { return texels_; }
    /// The same in eight bits.
    std::vector<std::uint8_t> bytes() const;

    /// C as the shaders read it at a path difference, µm: linear between two texels, in double precision.
    glm::dvec4 look(double pathUm, Row row) const noexcept;

private:
    std::vector<float> texels_;
};

}  // namespace nacre
