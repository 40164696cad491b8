#pragma once

#include <array>
#include <string>

#include <glm/vec3.hpp>

#include <nacre/material.hpp>

#include "model/material.hpp"
#include "point_program.hpp"

namespace nacre::test {

/// Everything that one evaluation depends on, in float32, so that both precisions see the same numbers.
/// The order is inputColumns()'.
struct Input {
    glm::vec3 light, view, upperNormal, lowerNormal, ior;
    float thicknessUm, upperExponent, lowerExponent, iorOutside;
    glm::vec3 wavelengthNm;
};
/// The same, one number after the other.
using Components = std::array<float, 22>;
static_assert(sizeof(Input) == sizeof(Components));
constexpr std::size_t thicknessComponent = 15;

Components components(const Input& input);
Input input(const Components& components);

/// What the input says about the material; the rest of it is default, thickness included.
nacre::Material material(const Input& input);
GpuPoint point(const Input& input, std::size_t material);

/// A line of CSV without its end, as nacre-eval reads it under inputColumns(). Nine digits bring a float
/// back; the thickness has as many as its product with 1000 needs, since the column is in nm.
std::string csvLine(const Input& input);

/// `direction` in float32, such that normalising and rounding it again changes nothing: what nacre-eval does.
glm::vec3 rounded(glm::dvec3 direction);

}  // namespace nacre::test
