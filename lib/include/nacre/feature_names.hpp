#pragma once

#include <array>
#include <string>
#include <string_view>

#include <nacre/features.hpp>
#include <nacre/result.hpp>

namespace nacre {

/// A feature as command lines and lists name it. The only place where the names stand.
struct FeatureName {
    std::string_view name;  ///< `total-reflection`
    std::string_view effect;
    bool (*holds)(const Features&);
    void (*set)(Features&);
};

/// All of them, in the order of Features; what a Features without any has is the cheapest.
const std::array<FeatureName, 21>& featureNames() noexcept;

/// The features of a list, `paper,specular,tilt`, canonical; lights and materials keep their defaults. Errors: a name
/// that is none, two that exclude each other.
Result<Features> featuresFromNames(std::string_view list);

/// The list that gives these features.
std::string namesOf(const Features& features);

}  // namespace nacre
