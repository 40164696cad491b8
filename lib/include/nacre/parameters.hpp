#pragma once

#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include <nacre/material.hpp>

namespace nacre {

/// One member of Material as a user meets it. The only place where names, units and ranges stand.
struct Parameter {
    using Member = std::variant<double Material::*, glm::dvec3 Material::*, int Material::*, LowerNormal Material::*,
                                Quality Material::*, Substrate Material::*, Lobes Material::*>;

    std::string_view name;    ///< As the member is spelt.
    std::string_view symbol;  ///< The paper's, empty where it has none.
    std::string_view unit;    ///< Empty for a plain number.
    double least, most;       ///< Inclusive range, of each channel.
    std::string_view option;  ///< Command-line option; members that share one are given together.
    std::string_view effect;  ///< What turning it does.
    Member member;
};

/// All members of Material in their order; their defaults are those of `Material{}`.
const std::array<Parameter, 22>& parameters() noexcept;

/// The names of the values of a member that is an enumeration, in their order; empty for the others.
const std::vector<std::string_view>& choices(const Parameter& parameter);
/// Such a member's value as an index of choices().
int choice(const Material& material, const Parameter& parameter) noexcept;
void setChoice(Material& material, const Parameter& parameter, int value) noexcept;

/// The names of an enumeration's values in their order.
const std::array<std::string_view, 4>& lowerNormalNames() noexcept;
const std::array<std::string_view, 2>& qualityNames() noexcept;
const std::array<std::string_view, 3>& substrateNames() noexcept;
const std::array<std::string_view, 2>& lobesNames() noexcept;

}  // namespace nacre
