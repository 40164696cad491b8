#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "log.hpp"
#include "needs.hpp"
#include "state.hpp"

namespace nacre::demo {

/// What the panel asks of the viewer.
struct PanelRequests {
    bool savePicture = false, saveGlsl = false, resetView = false;
    std::optional<std::string> openModel;
};

/// The side panel: model, preset, and tabs for the parameters, the comparison, what the material needs and the export.
class Panel {
public:
    /// Draws it there, changing the state as the user does. status: lines at the bottom.
    PanelRequests draw(State& state, ImVec2 corner, ImVec2 size, ImFont* codeFont, const std::string& status, Log& log);
    void focusModelField() { focusesModel_ = true; }

private:
    void drawModel(State& state, PanelRequests& requests, Log& log);
    void drawCompare(State& state, PanelRequests& requests, Log& log);
    void drawNeeds(const State& state, ImFont* codeFont, PanelRequests& requests, Log& log);
    void drawExport(State& state, ImFont* codeFont, PanelRequests& requests, Log& log);

    bool focusesModel_ = false;
    std::optional<Needs> needs_;
    Material needsOf_;
};

/// The preset of that name in the look, parameters and all.
void choosePreset(Look& look, const std::string& name);

/// Another comparison; what is compared first has two different presets.
void compare(State& state, Comparison comparison);

}  // namespace nacre::demo
