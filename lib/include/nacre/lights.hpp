#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <nacre/result.hpp>

namespace nacre {

/// The values are those of NACRE_LIGHT_* in the shaders.
enum class LightKind {
    directional = 0,  ///< So far away that it shines the same way everywhere.
    point = 1,
    spot = 2,
};

/// A light with the units of glTF's KHR_lights_punctual. Positions and directions are in the space in which the shader
/// states the shaded point. The defaults are the extension's.
struct LightSource {
    LightKind kind = LightKind::directional;
    glm::dvec3 colour{1.0};    ///< Linear, at least 0.
    double intensity = 1.0;    ///< Directional: lux. Point, spot: candela. 0 to 1e9.
    glm::dvec3 position{0.0};  ///< Point, spot.
    glm::dvec3 direction{0.0, 0.0, -1.0};  ///< Directional, spot: the way it shines; any length but 0.
    double range = 0.0;             ///< Point, spot: distance at which it ends; 0: nowhere.
    double innerConeDegrees = 0.0;  ///< Spot, from its axis: full up to here,
    double outerConeDegrees = 45.0; ///< nothing from here on; at most 90, more than innerConeDegrees.
};

/// A light in the block `nacre_Lights` (shaders/nacre_light_block.glsl), byte for byte as std140 lays it out.
struct LightBlock {
    float colour[3];
    float inverseRange;
    float position[3];
    std::int32_t kind;
    float direction[3];
    float angleScale;
    float angleOffset;
    float unused[3];
};
static_assert(sizeof(LightBlock) == 64, "std140: four rows of four words, none of them padded by the compiler");

/// What precedes the lights in that block.
struct LightHeader {
    std::int32_t count;
    std::int32_t unused[3];
};
static_assert(sizeof(LightHeader) == 16 && offsetof(LightBlock, angleOffset) == 48, "std140: an array starts at a row");

/// The block of a light; an error names the member that does not fit: `expected 0 <= intensity <= 1e+09, got -1`. Allocates
/// nothing where the light is valid.
Result<LightBlock> packLight(const LightSource& light);

/// The whole uniform buffer of the block `nacre_Lights` for a shader of `most` lights (Features::lights): the header,
/// the lights, and room for those that are not there. The error names the light: `lights[2]: expected …`.
Result<std::vector<unsigned char>> packLights(const std::vector<LightSource>& lights, int most);

}  // namespace nacre
