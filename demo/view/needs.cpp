#include "needs.hpp"

#include <nacre/block.hpp>
#include <nacre/glsl.hpp>

namespace nacre::demo {
namespace {

bool isGrey(glm::dvec3 value)
{
    return value.r == value.g && value.g == value.b;
}

}  // namespace

Result<Needs> needsOf(const Material& material)
{
    Result<std::string> text = glsl();
    if (!text) return text.error();
    const bool isPhysical = material.quality == Quality::physical;
    Needs needs;
    needs.glsl = *std::move(text);
    const auto say = [&](std::string line) { needs.lines.push_back(std::move(line)); };
    say(isPhysical ? "Quality physical: nacre_physicalView, nacre_physicalLight" : "Quality paper: nacre_view, nacre_light");
    say("Uniforms: nacre_Block, " + std::to_string(sizeof(Block)) + " bytes");
    say(isPhysical ? "Sampler: none, or the fringe table for thick films" : "Sampler: none");
    const bool isVarying = material.noiseOctaves > 0 && material.thicknessLeastNm != material.thicknessMostNm;
    say(isVarying ? "Thickness: noise of " + std::to_string(material.noiseOctaves) + " octaves" : "Thickness: constant, no noise");
    const bool isTilted = material.lowerNormal != LowerNormal::parallel && material.deviationDegrees != 0.0;
    say(isTilted ? "Boundaries: tilted, tangents are needed" : "Boundaries: parallel");
    say(isGrey(material.ior) ? "Index: one for all channels" : "Index: one per channel (dispersion)");
    if (material.specularWeight == 0.0) say("Diffuse part alone");
    if (material.diffuseWeight == 0.0) say("Specular part alone");
    return needs;
}

}  // namespace nacre::demo
