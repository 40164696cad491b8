// Renders a glTF model in the layered material, off screen: see --help.

#include <CLI/CLI.hpp>
#include <boost/timer/progress_display.hpp>

#include <unistd.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <nacre/presets.hpp>

#include "command_line.hpp"
#include "gallery.hpp"
#include "gl/context.hpp"
#include "material_options.hpp"
#include "models.hpp"
#include "picture_size.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "viewpoint_options.hpp"

namespace {

using namespace nacre;
using namespace nacre::demo;

struct Arguments {
    std::optional<std::string> model, preset, out, gallery;
    std::string size = "1024x1024";
    bool list = false;
    MaterialOptions material;
    ViewpointOptions viewpoint;
};

void list()
{
    std::cout << "Presets (--preset):\n";
    for (const Preset& preset : presets()) {
        std::cout << "  " << preset.name << std::string(18 - preset.name.size(), ' ') << preset.figure << ": " << preset.shows << '\n';
    }
    std::cout << "Models (MODEL): any .gltf or .glb file; without one\n  " << shippedModel().string() << '\n';
}

Outcome renderGallery(const Renderer& renderer, const Viewpoint& viewpoint, const std::string& directory, Size size)
{
    std::unique_ptr<boost::timer::progress_display> bar;
    return writeGallery(renderer, viewpoint, directory, size.width, size.height, [&](std::size_t done, std::size_t total) {
        if (!isatty(STDERR_FILENO)) return;
        if (!bar) bar = std::make_unique<boost::timer::progress_display>(total, std::cerr, "");
        *bar += done - bar->count();
    });
}

Outcome runOrThrow(const Arguments& arguments)
{
    if (arguments.out.has_value() == arguments.gallery.has_value()) {
        return Error{"expected either --out FILE or --gallery DIR; --help lists the options"};
    }
    if (arguments.gallery && arguments.preset) return Error{"--gallery: renders every preset, expected no --preset"};
    Result<Size> size = parseSize(arguments.size);
    if (!size) return size.error();
    Result<Material> base = arguments.preset ? preset(*arguments.preset) : Result<Material>(Material{});
    if (!base) {
        const std::string& reason = base.error().message;
        return Error{"--preset: " + reason.substr(reason.find(": ") + 2)};
    }
    Result<Material> material = arguments.material.apply(*base);
    if (!material) return material.error();
    Result<Viewpoint> viewpoint = arguments.viewpoint.viewpoint();
    if (!viewpoint) return viewpoint.error();
    if (arguments.out) {
        Outcome writable = checkWritable(*arguments.out);
        if (!writable) return Error{"--out: " + writable.error().message};
    }

    Result<Scene> scene = loadScene(arguments.model ? std::filesystem::path(*arguments.model) : shippedModel());
    if (!scene) return scene.error();
    Result<Context> context = Context::create();
    if (!context) return context.error();
    Result<Renderer> renderer = Renderer::create(context->gl(), *scene);
    if (!renderer) return renderer.error();

    if (Outcome drawable = renderer->checkSize(size->width, size->height); !drawable) return Error{"--size: " + drawable.error().message};
    if (arguments.gallery) return renderGallery(*renderer, *viewpoint, *arguments.gallery, *size);
    Result<Image> image = renderer->render(*material, size->width, size->height, *viewpoint);
    if (!image) return image.error();
    return writeImage(*image, *arguments.out);
}

// Memory can end anywhere between the model and the file.
Outcome run(const Arguments& arguments)
{
    try {
        return runOrThrow(arguments);
    } catch (const std::exception& exception) {
        return Error{std::string("cannot go on: ") + exception.what() + "; is there memory for a picture of this size?"};
    }
}

}  // namespace

int main(int argc, char** argv)
{
    Arguments arguments;
    CLI::App app{"Renders a glTF model in nacre's layered material, off screen.", "nacre-render"};
    app.add_option("MODEL", arguments.model, ".gltf or .glb file; without one, a shell that ships with the demo");
    app.add_option("--preset", arguments.preset, "A picture of the paper to start from; --list names them");
    app.add_option("--out", arguments.out, "File to write: .png (sRGB, 8 bits) or .exr (linear float)");
    app.add_option("--size", arguments.size, "Of the picture")->type_name("WIDTHxHEIGHT")->capture_default_str();
    app.add_option("--gallery", arguments.gallery, "Write every preset and a contact sheet into this directory instead");
    app.add_flag("--list", arguments.list, "List presets and models");
    arguments.material.addTo(app);
    arguments.viewpoint.addTo(app);
    if (const std::optional<int> status = parseCommandLine(app, argc, argv)) return *status;
    if (arguments.list) {
        list();
        return 0;
    }
    const Outcome outcome = run(arguments);
    if (outcome) return 0;
    std::string message = outcome.error().message;
    std::replace(message.begin(), message.end(), '\n', ' ');  // a name may hold one
    std::cerr << "nacre-render: " << message << '\n';
    return 1;
}
