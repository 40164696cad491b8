#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include <nacre/result.hpp>

#include "interface.hpp"
#include "keys.hpp"
#include "log.hpp"
#include "panel.hpp"
#include "render/renderer.hpp"
#include "scene_view.hpp"
#include "shader_folder.hpp"
#include "state.hpp"
#include "window.hpp"

namespace nacre::demo {

struct ViewerOptions {
    std::optional<std::filesystem::path> shaders;  ///< Watched while they are worked on.
    std::chrono::steady_clock::time_point start;   ///< Of the program.
};

/// The viewer's loop: it sleeps until something happens, and draws no frame that would look like the one before.
class Viewer {
public:
    /// The window and the log outlive the viewer. A scene that cannot be drawn is an error, here only.
    static Result<std::unique_ptr<Viewer>> create(Window& window, Log& log, State state, Scene scene, const ViewerOptions& options);
    /// Until the window is closed.
    Outcome run();

private:
    Viewer(Window& window, Log& log, State state, Renderer renderer, std::unique_ptr<SceneView> view, const ViewerOptions& options);

    enum class Drag { none, orbit, pan, light, divider };

    WindowEvents waitForChange();
    void obey(const WindowEvents& events);
    void obey(Command command);
    void readShaders();
    void turn();
    Outcome frame();
    void drawInterface();
    void drawSceneArea(ImVec2 size);
    void drawDivider(ImVec2 size);
    void drawMessages(ImVec2 size);
    void drawHelp(ImVec2 display);
    void navigate(ImVec2 size);
    void grant(const PanelRequests& requests);
    void openModel(const std::string& file);
    void savePicture();
    void saveGlsl();
    Outcome drawScene();
    std::string status() const;
    void report();

    Window& window_;
    Log& log_;
    State state_;
    Renderer renderer_;
    std::unique_ptr<SceneView> view_;
    Interface interface_;
    Panel panel_;
    std::optional<ShaderFolder> shaders_;
    std::chrono::steady_clock::time_point start_, lastTurn_;
    std::string driver_;

    Drag drag_ = Drag::none;
    ImVec2 sceneSize_{1.0F, 1.0F};  // in the interface's units, from the upper left corner of the window
    bool isStale_ = true;           // the scene or its shaders are others than what was drawn
    int framesLeft_ = 0;            // that the interface needs to settle
    long frames_ = 0, keys_ = 0;     // drawn; that went down
    double frameMilliseconds_ = 0.0;
};

}  // namespace nacre::demo
