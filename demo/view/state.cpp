#include "state.hpp"

#include <algorithm>

#include <nacre/parameters.hpp>
#include <nacre/presets.hpp>

namespace nacre::demo {

Material baseOf(const std::string& name)
{
    const Result<Material> found = preset(name);
    return found ? *found : Material{};
}

bool isSame(const Material& one, const Material& other)
{
    const auto& table = parameters();
    return std::all_of(table.begin(), table.end(), [&](const Parameter& parameter) {
        return std::visit([&](auto member) { return one.*member == other.*member; }, parameter.member);
    });
}

Material withoutLayer(Material material)
{
    material.ior = glm::dvec3(material.iorOutside);
    material.thicknessLeastNm = material.thicknessMostNm = 0.0;
    return material;
}

Material materialOf(const State& state, std::size_t side)
{
    switch (state.comparison) {
        case Comparison::off: return state.look().material;
        case Comparison::presets: return state.looks[side].material;
        case Comparison::quality: {
            Material material = state.look().material;
            material.quality = side == 0 ? Quality::paper : Quality::physical;
            return material;
        }
        case Comparison::layer: return side == 0 ? withoutLayer(state.look().material) : state.look().material;
    }
    return state.look().material;
}

std::string titleOf(const State& state, std::size_t side)
{
    switch (state.comparison) {
        case Comparison::off: return {};
        case Comparison::presets: {
            const Look& look = state.looks[side];
            return look.preset.empty() ? "default" : look.preset;
        }
        case Comparison::quality: return side == 0 ? "paper" : "physical";
        case Comparison::layer: return side == 0 ? "without the layer" : "with the layer";
    }
    return {};
}

}  // namespace nacre::demo
