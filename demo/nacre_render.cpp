// Renders a glTF model in the layered material, off screen: see --help.

#include <CLI/CLI.hpp>
#include <boost/timer/progress_display.hpp>

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <nacre/presets.hpp>

#include "command_line.hpp"
#include "gallery.hpp"
#include "material_options.hpp"
#include "models.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace {

using namespace nacre;
using namespace nacre::demo;

struct Arguments {
    std::string model;
    std::string preset;
    std::string out;
    std::string gallery;
    std::string size = "1024x1024";
    bool list = false;
    MaterialOptions material;
};

struct Size {
    int width = 0, height = 0;
};

Result<Size> parseSize(const std::string& text)
{
    Size size;
    char cross = 0, more = 0;
    std::istringstream stream(text);
    if (stream >> size.width >> cross >> size.height && cross == 'x' && !(stream >> more) && size.width > 0 && size.height > 0) return size;
    return Error{"--size: expected WIDTHxHEIGHT in whole numbers from 1, got '" + text + "'"};
}

void list()
{
    std::cout << "Presets (--preset):\n";
    for (const Preset& preset : presets()) {
        std::cout << "  " << preset.name << std::string(18 - preset.name.size(), ' ') << preset.figure << ": " << preset.shows << '\n';
    }
    std::cout << "Models (MODEL): any .gltf or .glb file; without one\n  " << shippedModel().string() << '\n';
}

Outcome renderGallery(const Renderer& renderer, const std::string& directory, Size size)
{
    std::unique_ptr<boost::timer::progress_display> bar;
    return writeGallery(renderer, directory, size.width, size.height, [&](std::size_t done, std::size_t total) {
        if (!isatty(STDERR_FILENO)) return;
        if (!bar) bar = std::make_unique<boost::timer::progress_display>(total, std::cerr, "");
        *bar += done - bar->count();
    });
}

Outcome run(const Arguments& arguments)
{
    if (arguments.out.empty() == arguments.gallery.empty()) {
        return Error{"expected either --out FILE or --gallery DIR; --help lists the options"};
    }
    if (!arguments.gallery.empty() && !arguments.preset.empty()) return Error{"--gallery: renders every preset, expected no --preset"};
    Result<Size> size = parseSize(arguments.size);
    if (!size) return size.error();
    Result<Material> base = arguments.preset.empty() ? Result<Material>(Material{}) : preset(arguments.preset);
    if (!base) {
        const std::string& reason = base.error().message;
        return Error{"--preset: " + reason.substr(reason.find(": ") + 2)};
    }
    Result<Material> material = arguments.material.apply(*base);
    if (!material) return material.error();
    if (!arguments.out.empty()) {
        Outcome writable = checkWritable(arguments.out);
        if (!writable) return Error{"--out: " + writable.error().message};
    }

    Result<Scene> scene = loadScene(arguments.model.empty() ? shippedModel() : std::filesystem::path(arguments.model));
    if (!scene) return scene.error();
    Result<Context> context = Context::create();
    if (!context) return context.error();
    Result<Renderer> renderer = Renderer::create(*context, *scene);
    if (!renderer) return renderer.error();

    if (!arguments.gallery.empty()) return renderGallery(*renderer, arguments.gallery, *size);
    Result<Image> image = renderer->render(*material, size->width, size->height);
    if (!image) return Error{"--size: " + image.error().message};
    return writeImage(*image, arguments.out);
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
    if (const std::optional<int> status = parseCommandLine(app, argc, argv)) return *status;
    if (arguments.list) {
        list();
        return 0;
    }
    const Outcome outcome = run(arguments);
    if (outcome) return 0;
    std::cerr << "nacre-render: " << outcome.error().message << '\n';
    return 1;
}
