#include "range_slider.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace nacre::demo {

bool rangeSlider(const char* id, double& lower, double& upper, double least, double most)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 size(ImGui::CalcItemWidth(), ImGui::GetFrameHeight());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, size);
    const float handle = style.GrabMinSize;
    const float left = corner.x + handle, width = std::max(size.x - 2.0F * handle, 1.0F);
    const auto placeOf = [&](double value) { return left + width * static_cast<float>(std::clamp((value - least) / (most - least), 0.0, 1.0)); };
    const auto valueAt = [&](float x) { return std::round(least + (most - least) * std::clamp((x - left) / width, 0.0F, 1.0F)); };

    // Which handle a drag holds is remembered while it lasts.
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID held = ImGui::GetID(id);
    const float mouse = ImGui::GetIO().MousePos.x;
    enum { none, lowerHandle, upperHandle, both };
    const double before[] = {lower, upper};
    if (ImGui::IsItemActivated()) {
        const float toLower = std::fabs(mouse - placeOf(lower)), toUpper = std::fabs(mouse - placeOf(upper));
        const bool isLower = toLower < toUpper || (toLower == toUpper && mouse < placeOf(lower));
        storage.SetInt(held, ImGui::GetIO().KeyShift ? both : isLower ? lowerHandle : upperHandle);
    }
    if (ImGui::IsItemActive()) {
        const int handleHeld = storage.GetInt(held, none);
        if (handleHeld == lowerHandle) lower = std::min(valueAt(mouse), upper);
        if (handleHeld == upperHandle) upper = std::max(valueAt(mouse), lower);
        if (handleHeld == both) {
            const double by = std::clamp(std::round((most - least) * static_cast<double>(ImGui::GetIO().MouseDelta.x / width)), least - lower, std::max(most - upper, 0.0));
            lower += by;
            upper += by;
        }
    }
    const bool isActive = ImGui::IsItemActive(), isHovered = ImGui::IsItemHovered();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y},
                       ImGui::GetColorU32(isActive ? ImGuiCol_FrameBgActive : isHovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), style.FrameRounding);
    const float inset = 0.38F * size.y;
    draw.AddRectFilled({placeOf(lower), corner.y + inset}, {placeOf(upper), corner.y + size.y - inset}, ImGui::GetColorU32(ImGuiCol_ButtonActive));
    for (const double value : {lower, upper}) {
        draw.AddRectFilled({placeOf(value) - 0.5F * handle, corner.y + 2.0F}, {placeOf(value) + 0.5F * handle, corner.y + size.y - 2.0F},
                           ImGui::GetColorU32(isActive ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab), style.GrabRounding);
    }
    return lower != before[0] || upper != before[1];
}

}  // namespace nacre::demo
