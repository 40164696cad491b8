// A window to turn a model and the layered material's parameters in: see --help, and F1 in it.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <nacre/presets.hpp>

#include "command_line.hpp"
#include "material_options.hpp"
#include "models.hpp"
#include "scene/scene.hpp"
#include "view/viewer.hpp"
#include "viewpoint_options.hpp"

namespace {

using namespace nacre;
using namespace nacre::demo;

struct Arguments {
    std::optional<std::string> model, preset, shaders, log;
    std::string size = "1280x720";
    double scale = 0.0;
    bool debugGl = false;
    MaterialOptions material;
    ViewpointOptions viewpoint;
};

Result<State> startingState(const Arguments& arguments)
{
    State state;
    state.model = arguments.model ? std::filesystem::path(*arguments.model) : shippedModel();
    const std::string name = arguments.preset.value_or("");
    Result<Material> base = arguments.preset ? preset(name) : Result<Material>(Material{});
    if (!base) {
        const std::string& reason = base.error().message;
        return Error{"--preset: " + reason.substr(reason.find(": ") + 2)};
    }
    Result<Material> material = arguments.material.apply(*base);
    if (!material) return material.error();
    Result<Viewpoint> viewpoint = arguments.viewpoint.viewpoint();
    if (!viewpoint) return viewpoint.error();
    state.looks = {Look{name, *material}, Look{name, *material}};
    state.viewpoint = *viewpoint;
    return state;
}

Outcome runOrThrow(const Arguments& arguments, std::chrono::steady_clock::time_point start)
{
    Result<Size> size = parseSize(arguments.size);
    if (!size) return size.error();
    Result<State> state = startingState(arguments);
    if (!state) return state.error();
    Log log = arguments.log ? Log(*arguments.log) : Log();
    if (arguments.log && !log.isGood()) return Error{"--log: cannot write '" + *arguments.log + "'"};
    Result<Scene> scene = loadScene(state->model);
    if (!scene) return scene.error();

    WindowOptions options;
    options.size = *size;
    options.scale = arguments.scale;
    options.debugGl = arguments.debugGl;
    Result<std::unique_ptr<Window>> window = Window::create(options);
    if (!window) return Error{window.error().message + "; nacre-render draws without a window"};
    std::optional<std::filesystem::path> shaders;
    if (arguments.shaders) shaders = *arguments.shaders;
    {
        Result<std::unique_ptr<Viewer>> viewer = Viewer::create(**window, log, *std::move(state), *std::move(scene), {shaders, start});
        if (!viewer) return viewer.error();
        if (Outcome outcome = (*viewer)->run(); !outcome) return outcome;
    }
    (*window)->collectGlErrors("closing");
    if (arguments.debugGl && (*window)->glErrors() > 0) {
        return Error{std::to_string((*window)->glErrors()) + " OpenGL errors, the first: " + (*window)->firstGlError()};
    }
    return std::monostate{};
}

Outcome run(const Arguments& arguments, std::chrono::steady_clock::time_point start)
{
    try {
        return runOrThrow(arguments, start);
    } catch (const std::exception& exception) {
        return Error{std::string("cannot go on: ") + exception.what()};
    }
}

}  // namespace

int main(int argc, char** argv)
{
    const auto start = std::chrono::steady_clock::now();
    Arguments arguments;
    CLI::App app{"Shows a glTF model in nacre's layered material, in a window. F1 there lists keys and mouse.", "nacre-view"};
    app.add_option("MODEL", arguments.model, ".gltf or .glb file; without one, a shell that ships with the demo");
    app.add_option("--preset", arguments.preset, "A picture of the paper to start from");
    app.add_option("--size", arguments.size, "Of the window, before scaling")->type_name("WIDTHxHEIGHT")->capture_default_str();
    app.add_option("--scale", arguments.scale, "Of text and controls, in place of the display's")->check(CLI::Range(0.5, 8.0));
    app.add_option("--shaders", arguments.shaders, "Read the GLSL files from this directory, and again when they change")->check(CLI::ExistingDirectory);
    app.add_option("--log", arguments.log, "Write what happens into this file, a line each, for scripts that drive the window");
    app.add_flag("--gl-debug", arguments.debugGl, "A debug context; its errors end in an exit status other than 0");
    arguments.material.addTo(app);
    arguments.viewpoint.addTo(app);
    if (const std::optional<int> status = parseCommandLine(app, argc, argv)) return *status;
    const Outcome outcome = run(arguments, start);
    if (outcome) return 0;
    std::string message = outcome.error().message;
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::cerr << "nacre-view: " << message << '\n';
    return 1;
}
