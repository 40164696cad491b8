#include <nacre/validate.hpp>

#include <nacre/parameters.hpp>

#include "number_text.hpp"

namespace nacre {
namespace {

// Builds no text unless there is a fault: packing a valid material allocates nothing.
void checkRange(std::vector<Fault>& faults, const Parameter& parameter, double value, const char* channel = "")
{
    if (value >= parameter.least && value <= parameter.most) return;  // false for NaN
    const std::string field = std::string(parameter.name) + channel;
    const std::string got = text(value);
    faults.push_back({field, got,
                      "expected " + text(parameter.least) + " <= " + field + " <= " + text(parameter.most) + ", got " + got});
}

}  // namespace

std::vector<Fault> validate(const Material& material)
{
    std::vector<Fault> faults;
    for (const Parameter& parameter : parameters()) {
        if (const auto* real = std::get_if<double Material::*>(&parameter.member)) {
            checkRange(faults, parameter, material.**real);
        } else if (const auto* rgb = std::get_if<glm::dvec3 Material::*>(&parameter.member)) {
            checkRange(faults, parameter, (material.**rgb).r, ".r");
            checkRange(faults, parameter, (material.**rgb).g, ".g");
            checkRange(faults, parameter, (material.**rgb).b, ".b");
        } else if (const auto* whole = std::get_if<int Material::*>(&parameter.member)) {
            checkRange(faults, parameter, material.**whole);
        } else {
            checkRange(faults, parameter, choice(material, parameter));
        }
    }
    if (material.thicknessLeastNm > material.thicknessMostNm) {
        const std::string got = text(material.thicknessLeastNm);
        faults.push_back({"thicknessLeastNm", got,
                          "expected thicknessLeastNm <= thicknessMostNm (" + text(material.thicknessMostNm) + "), got " + got});
    }
    return faults;
}

}  // namespace nacre
