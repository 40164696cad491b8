#include "parameter_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include <nacre/parameters.hpp>
#include <nacre/validate.hpp>

#include "material_options.hpp"
#include "numbers.hpp"
#include "range_slider.hpp"
#include "slider_span.hpp"

namespace nacre::demo {
namespace {

// `upperExponent` as `Upper exponent`; units are in the control.
std::string title(const Parameter& parameter)
{
    std::string name(parameter.name);
    for (const char* unit : {"Nm", "Degrees"}) {
        const std::size_t length = std::string_view(unit).size();
        if (name.size() > length && name.compare(name.size() - length, length, unit) == 0) name.resize(name.size() - length);
    }
    std::string words;
    for (const char c : name) {
        if (std::isupper(static_cast<unsigned char>(c))) words += ' ';
        words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (name == "ior") return "Index";
    if (name == "iorOutside") return "Index outside";
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    return words;
}

// What an effect begins with where quality paper takes no notice of the parameter.
constexpr std::string_view physicalOnly = "physical: ";

bool isPhysicalOnly(const Parameter& parameter)
{
    return parameter.effect.substr(0, physicalOnly.size()) == physicalOnly;
}

// Why turning it changes nothing now; empty where it does.
std::string idleReason(const Material& material, const Parameter& parameter, bool isPhysicalSeen)
{
    if (isPhysicalOnly(parameter) && !isPhysicalSeen) return "Quality paper takes no notice of it.";
    const auto is = [&](std::string_view name) { return parameter.name == name; };
    if (is("substrateIndex") && material.substrate == Substrate::f0) return "The substrate is given by its F0.";
    if (is("substrateAbsorption") && material.substrate != Substrate::metal) return "The substrate is no metal.";
    if (is("substrateF0") && material.substrate != Substrate::f0) return "The substrate is given by its index.";
    if (is("azimuthDegrees") && material.lowerNormal == LowerNormal::parallel) return "The boundaries are parallel.";
    if ((is("noiseFrequency") || is("noiseSeed")) && material.noiseOctaves == 0) return "There are no octaves of noise.";
    return {};
}

void tooltip(const Look& look, const Parameter& parameter, const std::string& idle)
{
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const std::string unit = parameter.unit.empty() ? "" : ' ' + std::string(parameter.unit);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(26.0F * ImGui::GetFontSize());
    ImGui::TextUnformatted((std::string(parameter.name) + (parameter.symbol.empty() ? "" : "   [" + std::string(parameter.symbol) + " in the paper]")).c_str());
    ImGui::Separator();
    ImGui::TextUnformatted(parameter.effect.data(), parameter.effect.data() + parameter.effect.size());
    if (choices(parameter).empty()) {
        ImGui::TextUnformatted(("Range " + numberText(parameter.least) + " to " + numberText(parameter.most) + unit).c_str());
    }
    ImGui::TextUnformatted(("Default " + valueText(Material{}, parameter) + unit).c_str());
    if (!look.preset.empty()) ImGui::TextUnformatted((look.preset + ": " + valueText(baseOf(look.preset), parameter) + unit).c_str());
    ImGui::TextDisabled("%s", ("nacre-render " + std::string(parameter.option)).c_str());
    if (!idle.empty()) ImGui::TextColored({1.0F, 0.8F, 0.4F, 1.0F}, "%s", idle.c_str());
    if (choices(parameter).empty()) ImGui::TextDisabled("Ctrl + click: type any value of the range");
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// Four digits are what a slider is good for, and what an export reads well with.
constexpr const char* digits = "%.4g";

std::string format(const Parameter& parameter)
{
    return digits + (parameter.unit.empty() ? "" : parameter.unit == "°" ? "°" : ' ' + std::string(parameter.unit));
}

ImGuiSliderFlags flags(const SliderSpan& span)
{
    return span.isLogarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
}

bool realControl(double& value, const Parameter& parameter)
{
    const SliderSpan span = sliderSpan(parameter);
    if (!ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &span.least, &span.most, format(parameter).c_str(), flags(span))) return false;
    value = std::clamp(value, parameter.least, parameter.most);
    return true;
}

bool wholeControl(int& value, const Parameter& parameter)
{
    const SliderSpan span = sliderSpan(parameter);
    if (!ImGui::SliderInt("##value", &value, static_cast<int>(span.least), static_cast<int>(span.most))) return false;
    value = std::clamp(value, static_cast<int>(parameter.least), static_cast<int>(parameter.most));
    return true;
}

bool choiceControl(Material& material, const Parameter& parameter, Log& log)
{
    const auto& names = choices(parameter);
    const int chosen = choice(material, parameter);
    bool changed = false;
    if (ImGui::BeginCombo("##value", names[static_cast<std::size_t>(chosen)].data())) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (ImGui::Selectable(names[i].data(), static_cast<int>(i) == chosen)) {
                setChoice(material, parameter, static_cast<int>(i));
                changed = true;
            }
            log.widget(std::string(parameter.name) + ':' + std::string(names[i]));
        }
        ImGui::EndCombo();
    }
    return changed;
}

double curved(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double straightened(double curved)
{
    return curved <= 0.04045 ? curved / 12.92 : std::pow((curved + 0.055) / 1.055, 2.4);
}

// Chosen by eye, so as sRGB; the material's is linear.
bool colourControl(glm::dvec3& value)
{
    float shown[3];
    for (int i = 0; i < 3; ++i) shown[i] = static_cast<float>(curved(value[i]));
    if (!ImGui::ColorEdit3("##value", shown, ImGuiColorEditFlags_Uint8)) return false;
    for (int i = 0; i < 3; ++i) value[i] = std::clamp(std::round(1e4 * straightened(static_cast<double>(shown[i]))) / 1e4, 0.0, 1.0);
    return true;
}

// Three sliders, each with a bar of its channel's colour; with Shift all move together.
bool channelsControl(glm::dvec3& value, const Parameter& parameter)
{
    const SliderSpan span = sliderSpan(parameter);
    const ImU32 colours[] = {IM_COL32(220, 80, 70, 255), IM_COL32(90, 190, 90, 255), IM_COL32(90, 130, 240, 255)};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, width = (ImGui::CalcItemWidth() - 2.0F * gap) / 3.0F;
    bool changed = false;
    ImGui::BeginGroup();
    for (int channel = 0; channel < 3; ++channel) {
        ImGui::PushID(channel);
        if (channel > 0) ImGui::SameLine(0.0F, gap);
        ImGui::SetNextItemWidth(std::floor(width));
        double one = value[channel];
        if (ImGui::SliderScalar("##value", ImGuiDataType_Double, &one, &span.least, &span.most, digits, flags(span))) {
            one = std::clamp(one, parameter.least, parameter.most);
            if (ImGui::GetIO().KeyShift) value = glm::dvec3(one);
            else value[channel] = one;
            changed = true;
        }
        const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRectFilled({least.x, most.y - 0.1F * (most.y - least.y)}, most, colours[channel]);
        ImGui::PopID();
    }
    ImGui::EndGroup();
    return changed;
}

bool control(Material& material, const Parameter& parameter, Log& log)
{
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (!choices(parameter).empty()) return choiceControl(material, parameter, log);
    if (const auto* whole = std::get_if<int Material::*>(&parameter.member)) return wholeControl(material.**whole, parameter);
    if (const auto* real = std::get_if<double Material::*>(&parameter.member)) return realControl(material.**real, parameter);
    const auto* rgb = std::get_if<glm::dvec3 Material::*>(&parameter.member);
    const bool isColour = parameter.least == 0.0 && parameter.most == 1.0;
    if (isColour) return colourControl(material.**rgb);
    return channelsControl(material.**rgb, parameter);
}

// The bounds of the thickness are one range: a slider with two handles, and the numbers below it.
bool thicknessControl(Material& material, const Parameter& least, const Parameter& most)
{
    const SliderSpan span = sliderSpan(least);
    double &lower = material.thicknessLeastNm, &upper = material.thicknessMostNm;
    bool changed = false;
    ImGui::BeginGroup();
    ImGui::SetNextItemWidth(-FLT_MIN);
    changed |= rangeSlider("##range", lower, upper, span.least, span.most);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, width = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    const std::string text = format(least);
    ImGui::SetNextItemWidth(std::floor(width));
    if (ImGui::DragScalar("##least", ImGuiDataType_Double, &lower, 1.0F, &least.least, &upper, text.c_str())) {
        lower = std::clamp(lower, least.least, upper);
        changed = true;
    }
    ImGui::SameLine(0.0F, gap);
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::DragScalar("##most", ImGuiDataType_Double, &upper, 1.0F, &lower, &most.most, text.c_str())) {
        upper = std::clamp(upper, lower, most.most);
        changed = true;
    }
    ImGui::EndGroup();
    return changed;
}

void assign(Material& material, const Material& source, const Parameter& parameter)
{
    std::visit([&](auto member) { material.*member = source.*member; }, parameter.member);
}

}  // namespace

bool parameterRows(Look& look, bool isPhysicalSeen, Log& log)
{
    const Material base = baseOf(look.preset);
    const float em = ImGui::GetFontSize();
    if (!ImGui::BeginTable("parameters", 3, ImGuiTableFlags_SizingFixedFit)) return false;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 9.4F * em);
    ImGui::TableSetupColumn("control", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, 1.6F * em);
    bool changed = false;
    const auto& table = parameters();
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Parameter& parameter = table[i];
        const bool isRange = parameter.name == "thicknessLeastNm" && i + 1 < table.size();
        const std::string idle = idleReason(look.material, parameter, isPhysicalSeen);
        Material next = look.material;
        bool isTouched = false;

        ImGui::PushID(static_cast<int>(i));
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::AlignTextToFramePadding();
        const std::string name = isRange ? "Thickness" : title(parameter);
        if (idle.empty()) ImGui::TextUnformatted(name.c_str());
        else ImGui::TextDisabled("%s", name.c_str());
        tooltip(look, parameter, idle);
        if (!parameter.symbol.empty()) {
            ImGui::SameLine();
            ImGui::TextDisabled("%s", std::string(parameter.symbol).c_str());
        }

        ImGui::TableNextColumn();
        ImGui::BeginDisabled(!idle.empty());
        isTouched |= isRange ? thicknessControl(next, parameter, table[i + 1]) : control(next, parameter, log);
        log.widget(isRange ? "thickness" : std::string(parameter.name));
        tooltip(look, parameter, idle);
        ImGui::EndDisabled();

        ImGui::TableNextColumn();
        const bool isOther = valueText(look.material, parameter) != valueText(base, parameter) ||
                             (isRange && valueText(look.material, table[i + 1]) != valueText(base, table[i + 1]));
        if (isOther) {
            if (ImGui::Button("↺")) {
                assign(next, base, parameter);
                if (isRange) assign(next, base, table[i + 1]);
                isTouched = true;
            }
            log.widget("reset:" + std::string(parameter.name));
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("Back to %s", look.preset.empty() ? "the default" : look.preset.c_str());
        }
        ImGui::PopID();
        if (isRange) ++i;

        if (!isTouched) continue;
        // As on the command line: a deviation is meant to be seen.
        const bool isTilted = next.deviationDegrees != look.material.deviationDegrees && next.deviationDegrees != 0.0;
        if (isTilted && next.lowerNormal == LowerNormal::parallel) next.lowerNormal = LowerNormal::constant;
        if (!validate(next).empty()) continue;
        look.material = next;
        changed = true;
    }
    ImGui::EndTable();
    return changed;
}

}  // namespace nacre::demo
