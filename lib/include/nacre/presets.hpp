#pragma once

#include <array>
#include <string_view>

#include <nacre/material.hpp>
#include <nacre/result.hpp>

namespace nacre {

/// A picture of the paper.
struct Preset {
    std::string_view name;     ///< `figure-3-left`
    std::string_view figure;   ///< `Figure 3, left`
    std::string_view shows;    ///< What the paper shows with it.
    Material material;
};

/// The pictures of Figures 2 to 5 in their order.
const std::array<Preset, 9>& presets() noexcept;

/// The material of that name; the error lists the names there are.
Result<Material> preset(std::string_view name);

}  // namespace nacre
