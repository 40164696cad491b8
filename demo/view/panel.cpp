#include "panel.hpp"

#include <imgui_stdlib.h>

#include <nacre/presets.hpp>

#include "models.hpp"
#include "parameter_rows.hpp"
#include "snippet.hpp"

namespace nacre::demo {
namespace {

constexpr const char* comparisonNames[] = {"Off", "Preset against preset", "Paper against physical", "Layer off against on"};

// A label before its control, which takes the rest of the line.
void labelled(const char* label)
{
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(4.2F * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(-FLT_MIN);
}

bool presetCombo(const char* id, Look& look, Log& log)
{
    const bool isChanged = !isSame(look.material, baseOf(look.preset));
    const std::string shown = (look.preset.empty() ? "default" : look.preset) + (isChanged ? " (changed)" : "");
    bool chosen = false;
    const bool isOpen = ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLargest);
    if (!isOpen) log.widget(std::string("combo") + id);
    if (!isOpen) return false;
    const auto choice = [&](const std::string& name, const std::string& shows) {
        const std::string label = name.empty() ? "default" : name;
        if (ImGui::Selectable(label.c_str(), name == look.preset)) {
            choosePreset(look, name);
            chosen = true;
        }
        log.widget("preset:" + label);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", shows.c_str());
    };
    choice("", "crown glass, 200 to 400 nm");
    for (const Preset& preset : presets()) choice(std::string(preset.name), std::string(preset.figure) + ": " + std::string(preset.shows));
    ImGui::EndCombo();
    return chosen;
}

void codeBlock(const char* id, const std::string& text, ImFont* font, float height, bool wraps)
{
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    if (ImGui::BeginChild(id, {0.0F, height}, false, wraps ? ImGuiWindowFlags_AlwaysUseWindowPadding : ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_HorizontalScrollbar)) {
        ImGui::PushFont(font);
        if (wraps) ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
        if (wraps) ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

// A heading with a button at the end of its line that copies the text.
void copyable(const char* heading, const std::string& text, Log& log)
{
    ImGui::PushID(heading);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(heading);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 4.5F * ImGui::GetFontSize());
    if (ImGui::Button("Copy", {4.5F * ImGui::GetFontSize(), 0.0F})) {
        ImGui::SetClipboardText(text.c_str());
        log.event("copied", heading);
    }
    log.widget(std::string("copy:") + heading);
    ImGui::PopID();
}

}  // namespace

void choosePreset(Look& look, const std::string& name)
{
    look = {name, baseOf(name)};
}

void compare(State& state, Comparison comparison)
{
    const auto isSameLook = [&] {
        return state.looks[0].preset == state.looks[1].preset && isSame(state.looks[0].material, state.looks[1].material);
    };
    if (comparison == Comparison::presets && isSameLook()) {
        choosePreset(state.looks[1 - state.edited], state.look().preset == "figure-3-left" ? "figure-3-right" : "figure-3-left");
    }
    state.comparison = comparison;
}

PanelRequests Panel::draw(State& state, ImVec2 corner, ImVec2 size, ImFont* codeFont, const std::string& status, Log& log)
{
    PanelRequests requests;
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize(size);
    constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus;
    ImGui::Begin("panel", nullptr, fixed);
    drawModel(state, requests, log);
    labelled("Preset");
    presetCombo("##preset", state.look(), log);
    if (state.comparison == Comparison::presets) {
        labelled("Edit");
        const std::string left = "left: " + titleOf(state, 0), right = "right: " + titleOf(state, 1);
        if (ImGui::RadioButton(left.c_str(), state.edited == 0)) state.edited = 0;
        log.widget("edit:left");
        ImGui::SameLine();
        if (ImGui::RadioButton(right.c_str(), state.edited == 1)) state.edited = 1;
        log.widget("edit:right");
    }

    const float footer = ImGui::GetTextLineHeightWithSpacing() * 2.0F + ImGui::GetStyle().ItemSpacing.y;
    if (ImGui::BeginTabBar("tabs")) {
        const auto tab = [&](const char* name, auto&& contents) {
            const bool isOpen = ImGui::BeginTabItem(name);
            log.widget(std::string("tab:") + name);
            if (!isOpen) return;
            if (ImGui::BeginChild(name, {0.0F, -footer})) contents();
            ImGui::EndChild();
            ImGui::EndTabItem();
        };
        tab("Material", [&] {
            const bool isPhysicalSeen = state.comparison == Comparison::quality || state.look().material.quality == Quality::physical;
            parameterRows(state.look(), isPhysicalSeen, log);
        });
        tab("Compare", [&] { drawCompare(state, requests, log); });
        tab("Needs", [&] { drawNeeds(state, codeFont, requests, log); });
        tab("Export", [&] { drawExport(state, codeFont, requests, log); });
        ImGui::EndTabBar();
    }
    ImGui::SetCursorPosY(size.y - footer);
    ImGui::TextDisabled("%s", status.c_str());
    ImGui::End();
    return requests;
}

void Panel::drawModel(State& state, PanelRequests& requests, Log& log)
{
    labelled("Model");
    const float button = 4.0F * ImGui::GetFontSize(), gap = ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(-2.0F * (button + gap));
    if (focusesModel_) ImGui::SetKeyboardFocusHere();
    focusesModel_ = false;
    const std::string hint = state.model.filename().string();
    const bool isEntered = ImGui::InputTextWithHint("##model", hint.c_str(), &state.modelField, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    log.widget("model");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Open: %s\nType the name of another .gltf or .glb file and Enter, or drop it on the window", state.model.string().c_str());
    ImGui::SameLine();
    if ((ImGui::Button("Open", {button, 0.0F}) || isEntered) && !state.modelField.empty()) requests.openModel = state.modelField;
    log.widget("open");
    ImGui::SameLine();
    if (ImGui::Button("Shell", {button, 0.0F})) requests.openModel = shippedModel().string();
    log.widget("open-shell");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("The model that ships with nacre");
}

void Panel::drawCompare(State& state, PanelRequests& requests, Log& log)
{
    ImGui::Spacing();
    ImGui::TextUnformatted("Two sides, a line between them to drag");
    for (int i = 0; i < 4; ++i) {
        if (ImGui::RadioButton(comparisonNames[i], static_cast<int>(state.comparison) == i)) compare(state, static_cast<Comparison>(i));
        log.widget("compare:" + std::to_string(i));
    }
    if (state.comparison == Comparison::presets) {
        labelled("Left");
        presetCombo("##left", state.looks[0], log);
        labelled("Right");
        presetCombo("##right", state.looks[1], log);
    }
    if (state.comparison == Comparison::quality) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextDisabled("Physical divides the diffuse part by π, as a BRDF is; the paper does not, so that its side is brighter.");
        ImGui::PopTextWrapPos();
    }
    if (state.comparison == Comparison::layer) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextDisabled("Without the layer: its index is the outside's and its thickness 0. The light meets the lower boundary alone.");
        ImGui::PopTextWrapPos();
    }
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    ImGui::Checkbox("Magnifier (M)", &state.magnifier);
    log.widget("magnifier");
    ImGui::Checkbox("Turntable (Space)", &state.turntable);
    log.widget("turntable");
    if (ImGui::Button("Reset camera and light (Home)")) requests.resetView = true;
    log.widget("reset-view");
    ImGui::TextDisabled("F1 lists keys and mouse");
}

void Panel::drawNeeds(const State& state, ImFont* codeFont, PanelRequests& requests, Log& log)
{
    const Material& material = state.look().material;
    if (!needs_ || !isSame(material, needsOf_)) {
        Result<Needs> needs = nacre::demo::needsOf(material);
        needsOf_ = material;
        if (needs) needs_ = *std::move(needs);
        else needs_ = Needs{{needs.error().message}, {}};
    }
    ImGui::Spacing();
    ImGui::TextUnformatted("What this material needs");
    ImGui::PushTextWrapPos(0.0F);
    for (const std::string& line : needs_->lines) {
        ImGui::Bullet();
        ImGui::SameLine();
        ImGui::TextWrapped("%s", line.c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    copyable("GLSL", needs_->glsl, log);
    codeBlock("glsl", needs_->glsl, codeFont, -1.6F * ImGui::GetFrameHeight(), false);
    if (ImGui::Button("Save the GLSL beside the picture")) requests.saveGlsl = true;
    log.widget("save-glsl");
}

void Panel::drawExport(State& state, ImFont* codeFont, PanelRequests& requests, Log& log)
{
    ImGui::Spacing();
    ImGui::TextUnformatted("Picture, as nacre-render draws it");
    labelled("File");
    ImGui::InputText("##file", &state.pictureFile, ImGuiInputTextFlags_AutoSelectAll);
    log.widget("picture-file");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip(".png: sRGB, 8 bits; .exr: linear float");
    labelled("Size");
    const float button = 6.0F * ImGui::GetFontSize();
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
    ImGui::InputText("##size", &state.pictureSize, ImGuiInputTextFlags_AutoSelectAll);
    log.widget("picture-size");
    ImGui::SameLine();
    if (ImGui::Button("Save", {button, 0.0F})) requests.savePicture = true;
    log.widget("save-picture");
    if (state.comparison != Comparison::off) ImGui::TextDisabled("One side: the one whose parameters are edited");

    const std::string code = snippet(state.look()), command = renderCommand(state);
    ImGui::Spacing();
    copyable("C++", code, log);
    codeBlock("c++", code, codeFont, 9.0F * ImGui::GetTextLineHeight(), false);
    ImGui::Spacing();
    copyable("nacre-render", command, log);
    codeBlock("command", command, codeFont, 0.0F, true);
}

}  // namespace nacre::demo
