#include <nacre/feature_names.hpp>

#include <algorithm>
#include <vector>

namespace nacre {
namespace {

template <bool Features::*Member>
constexpr FeatureName flag(std::string_view name, std::string_view effect)
{
    return {name, effect, [](const Features& f) { return f.*Member; }, [](Features& f) { f.*Member = true; }};
}

template <ThicknessSource Value>
constexpr FeatureName thickness(std::string_view name, std::string_view effect)
{
    return {name, effect, [](const Features& f) { return f.thickness == Value; }, [](Features& f) { f.thickness = Value; }};
}

template <LowerNormals Value>
constexpr FeatureName tilt(std::string_view name, std::string_view effect)
{
    return {name, effect, [](const Features& f) { return f.lowerNormals == Value; }, [](Features& f) { f.lowerNormals = Value; }};
}

template <Fringes Value>
constexpr FeatureName fringes(std::string_view name, std::string_view effect)
{
    return {name, effect, [](const Features& f) { return f.fringes == Value; }, [](Features& f) { f.fringes = Value; }};
}

Features cheapest()
{
    Features f;
    f.paper = f.physical = f.specular = f.diffuse = f.dispersion = f.totalReflection = false;
    f.substrateChannels = f.metal = f.normalised = f.stableLobes = f.splitPhase = f.polynomialCosine = false;
    f.thickness = ThicknessSource::constant;
    f.lowerNormals = LowerNormals::parallel;
    f.fringes = Fringes::samplerFree;
    return f;
}

std::vector<std::string_view> split(std::string_view list)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t end = std::min(list.find(','), list.size());
        parts.push_back(list.substr(0, end));
        if (end == list.size()) return parts;
        list.remove_prefix(end + 1);
    }
}

std::string allNames()
{
    std::string names;
    for (const FeatureName& feature : featureNames()) names += (names.empty() ? "" : ", ") + std::string(feature.name);
    return names;
}

}  // namespace

const std::array<FeatureName, 21>& featureNames() noexcept
{
    static constexpr std::array<FeatureName, 21> table{{
        flag<&Features::paper>("paper", "quality paper; with physical too the material decides at run time"),
        flag<&Features::physical>("physical", "quality physical"),
        flag<&Features::specular>("specular", "the two lobes"),
        flag<&Features::diffuse>("diffuse", "the diffuse part"),
        flag<&Features::dispersion>("dispersion", "an index of the layer per channel"),
        flag<&Features::totalReflection>("total-reflection", "an index of the layer below the outside's"),
        thickness<ThicknessSource::constant>("constant-thickness", "the same thickness everywhere; so it is without another"),
        thickness<ThicknessSource::noise>("noise", "thickness by noise"),
        thickness<ThicknessSource::map>("thickness-map", "thickness from the host, per pixel"),
        tilt<LowerNormals::constant>("constant-tilt", "a lower boundary that leans by one angle"),
        tilt<LowerNormals::independent>("independent-tilt", "one that leans by noise of its own"),
        tilt<LowerNormals::gradient>("gradient-tilt", "one that follows the thickness"),
        tilt<LowerNormals::any>("tilt", "one that leans in any way"),
        flag<&Features::substrateChannels>("substrate-channels", "physical: something else below per channel"),
        flag<&Features::metal>("metal", "physical: a metal below"),
        flag<&Features::normalised>("normalised", "physical: normalised lobes"),
        fringes<Fringes::table>("fringe-table", "physical: fringes from a texture; without: sampler-free"),
        fringes<Fringes::either>("either-fringes", "physical: functions for both"),
        flag<&Features::stableLobes>("stable-lobes", "lobes to the last digit"),
        flag<&Features::splitPhase>("split-phase", "paper: phase of a thick layer, in two parts"),
        flag<&Features::polynomialCosine>("polynomial-cosine", "paper: the library's cosine"),
    }};
    return table;
}

Result<Features> featuresFromNames(std::string_view list)
{
    const auto& table = featureNames();
    Features features = cheapest();
    std::vector<const FeatureName*> given;
    for (std::string_view name : split(list)) {
        const auto found = std::find_if(table.begin(), table.end(), [&](const FeatureName& f) { return f.name == name; });
        if (found == table.end()) {
            return Error{"nacre::featuresFromNames(): no feature '" + std::string(name) + "', there are " + allNames()};
        }
        found->set(features);
        given.push_back(found);
    }
    for (const FeatureName* feature : given) {
        if (feature->holds(features)) continue;
        return Error{"nacre::featuresFromNames(): '" + std::string(feature->name) + "' and another of '" + std::string(list) +
                     "' exclude each other"};
    }
    return canonical(features);
}

std::string namesOf(const Features& features)
{
    const Features f = canonical(features);
    std::string names;
    for (const FeatureName& feature : featureNames()) {
        if (feature.holds(f)) names += (names.empty() ? "" : ",") + std::string(feature.name);
    }
    return names;
}

}  // namespace nacre
