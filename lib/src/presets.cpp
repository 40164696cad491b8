#include <nacre/presets.hpp>

#include <string>

namespace nacre {
namespace {

Material material(glm::dvec3 ior, double thicknessLeastNm, double thicknessMostNm)
{
    Material m;
    m.ior = ior;
    m.thicknessLeastNm = thicknessLeastNm;
    m.thicknessMostNm = thicknessMostNm;
    return m;
}

// Figure 2: the diffuse part alone, one index for all channels.
Material diffuse(double ior, double thicknessLeastNm, double thicknessMostNm)
{
    Material m = material(glm::dvec3(ior), thicknessLeastNm, thicknessMostNm);
    m.specularWeight = 0.0;
    m.diffuseWeight = 1.0;
    m.noiseFrequency = 3.0;
    m.noiseOctaves = 4;
    return m;
}

Material figure3(LowerNormal lowerNormal, double deviationDegrees, double diffuseWeight)
{
    Material m = material({1.4, 1.45, 1.6}, 66.0, 76.0);
    m.lowerNormal = lowerNormal;
    m.deviationDegrees = deviationDegrees;
    m.upperExponent = 90.0;
    m.lowerExponent = 170.0;
    m.diffuseWeight = diffuseWeight;
    return m;
}

Material figure5(double thicknessLeastNm, double thicknessMostNm)
{
    Material m = material({1.5, 1.6, 1.8}, thicknessLeastNm, thicknessMostNm);
    m.lowerNormal = LowerNormal::constant;
    m.deviationDegrees = 14.0;
    m.upperExponent = 130.0;
    m.lowerExponent = 130.0;
    m.diffuseWeight = 0.5;
    return m;
}

// The paper does not say how far the thickness tilts the lower boundary in Figure 4. Bands like
// oil's need a tilt wider than the lobe and a smooth thickness: one octave.
Material figure4()
{
    Material m = figure3(LowerNormal::gradient, 12.0, 0.0);
    m.noiseFrequency = 6.0;
    m.noiseOctaves = 1;
    return m;
}

}  // namespace

const std::array<Preset, 9>& presets() noexcept
{
    static const std::array<Preset, 9> table{{
        {"figure-2-left", "Figure 2, left", "old metal, diffuse part alone", diffuse(1.5, 1.0, 30.0)},
        {"figure-2-centre", "Figure 2, centre", "coloured, diffuse part alone", diffuse(1.3, 1.0, 210.0)},
        {"figure-2-right", "Figure 2, right", "clay, diffuse part alone", diffuse(1.4, 67.0, 73.0)},
        {"figure-3-left", "Figure 3, left", "parallel boundaries", figure3(LowerNormal::parallel, 0.0, 0.7)},
        {"figure-3-right", "Figure 3, right", "constant deviation of 10°", figure3(LowerNormal::constant, 10.0, 0.7)},
        {"figure-4", "Figure 4", "lower normal from the thickness, specular part alone", figure4()},
        {"figure-5-left", "Figure 5, left", "both parts, 1-30 nm", figure5(1.0, 30.0)},
        {"figure-5-centre", "Figure 5, centre", "both parts, 79-106 nm", figure5(79.0, 106.0)},
        {"figure-5-right", "Figure 5, right", "both parts, 146-200 nm", figure5(146.0, 200.0)},
    }};
    return table;
}

Result<Material> preset(std::string_view name)
{
    std::string names;
    for (const Preset& preset : presets()) {
        if (preset.name == name) return preset.material;
        names += (names.empty() ? "" : ", ") + std::string(preset.name);
    }
    return Error{"nacre::preset(): no preset '" + std::string(name) + "', there are " + names};
}

}  // namespace nacre
