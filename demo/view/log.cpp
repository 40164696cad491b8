#include "log.hpp"

#include <imgui.h>

#include <algorithm>

namespace nacre::demo {

void Log::event(const std::string& name, const std::string& value)
{
    if (!isOn_) return;
    std::string line = value;
    std::replace(line.begin(), line.end(), '\n', ' ');
    stream_ << name << ' ' << line << std::endl;  // whoever waits for it reads it now
}

void Log::state(const std::string& name, const std::string& value)
{
    if (!isOn_) return;
    const auto [place, isNew] = last_.try_emplace(name, value);
    if (!isNew && place->second == value) return;
    place->second = value;
    event(name, value);
}

void Log::widget(const std::string& name)
{
    if (!isOn_) return;
    const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
    const auto whole = [](float value) { return std::to_string(static_cast<int>(value)); };
    const std::string place = whole(least.x) + ' ' + whole(least.y) + ' ' + whole(most.x) + ' ' + whole(most.y);
    state("widget:" + name, ImGui::IsItemVisible() ? place : "hidden");
}

}  // namespace nacre::demo
