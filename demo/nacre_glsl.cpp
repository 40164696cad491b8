// Prints the GLSL for a material or a list of features, for engines that take text at build time: see --help.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>

#include <nacre/feature_names.hpp>
#include <nacre/glsl.hpp>
#include <nacre/presets.hpp>

#include "command_line.hpp"
#include "glsl/complete_shader.hpp"
#include "glsl/version.hpp"
#include "material_options.hpp"
#include "output_file.hpp"

namespace {

using namespace nacre;
using namespace nacre::demo;

struct Arguments {
    std::optional<std::string> preset, features, out;
    std::string version = "330", uniforms = "block", machine = "gpu", fringes = "table";
    std::optional<int> lights;
    int materials = 1;
    FeatureOptions options;
    bool withConditionals = false, complete = false, list = false;
    MaterialOptions material;
};

std::string row(std::string_view name, const std::string& text)
{
    return "  " + std::string(name) + std::string(20 - name.size(), ' ') + text + '\n';
}

std::string list()
{
    std::string text = "Presets (--preset):\n";
    for (const Preset& preset : presets()) text += row(preset.name, std::string(preset.figure) + ": " + std::string(preset.shows));
    text += "Features (--features):\n";
    for (const FeatureName& feature : featureNames()) text += row(feature.name, std::string(feature.effect));
    return text;
}

// The library's message as that of an option.
Error of(const char* option, const Error& error)
{
    const std::size_t function = error.message.find("): ");
    return {std::string(option) + ": " + (function == std::string::npos ? error.message : error.message.substr(function + 3))};
}

// Which option the library finds fault with when it puts the text together.
Error ofGlsl(const Error& error)
{
    const auto names = [&](const char* word) { return error.message.find(word) != std::string::npos; };
    return of(names("materials in") ? "--materials" : names("lights in") ? "--lights" : names("plain ones") ? "--uniforms" : "--version", error);
}

Result<Features> featuresOfMaterial(const Arguments& arguments)
{
    const Result<Material> base = arguments.preset ? preset(*arguments.preset) : Result<Material>(Material{});
    if (!base) return of("--preset", base.error());
    const Result<Material> material = arguments.material.apply(*base);
    if (!material) return material.error();
    FeatureOptions options = arguments.options;
    options.machine = arguments.machine == "cpu" ? Machine::cpu : Machine::gpu;
    options.fringes = arguments.fringes == "table" ? Fringes::table : Fringes::samplerFree;
    Result<Features> features = featuresOf(*material, options);
    if (!features) return of("--error", features.error());  // all else is checked
    return features;
}

Result<Features> features(const Arguments& arguments)
{
    if (arguments.features && (arguments.preset || arguments.material.areGiven())) {
        return Error{"--features: expected no material beside the list of its features"};
    }
    Result<Features> result = arguments.features ? featuresFromNames(*arguments.features) : featuresOfMaterial(arguments);
    if (!result) return arguments.features ? of("--features", result.error()) : result.error();
    if (arguments.lights.value_or(1) < 1) return Error{"--lights: expected 1 or more, got " + std::to_string(*arguments.lights)};
    result->lights = arguments.lights.value_or(4);
    result->materials = arguments.materials;
    return result;
}

GlslUniforms uniforms(const std::string& name)
{
    return name == "plain" ? GlslUniforms::plain : name == "none" ? GlslUniforms::none : GlslUniforms::block;
}

// Says where the text is from and what it is for; the library's files do not.
std::string heading(const GlslOptions& options, bool isComplete)
{
    char number[19] = {};
    std::snprintf(number, sizeof number, "0x%016" PRIx64, key(options.features));
    std::string text = "// nacre " NACRE_VERSION ", a layered iridescent material after Granier & Heidrich 2003.\n"
                       "// Copyright (c) 2026 The nacre authors, MIT License.\n"
                       "// Made by nacre-glsl for GLSL " + versionText(options) + ", key " + number + ":\n"
                       "//   --features " + namesOf(options.features) + '\n';
    if (options.es && !isComplete) text += "// Before it the shader has to say: precision highp float; precision highp int;\n";
    return text;
}

Result<std::string> shader(const Arguments& arguments)
{
    GlslOptions options;
    if (Outcome outcome = setVersion(options, arguments.version); !outcome) return outcome.error();
    Result<Features> wanted = features(arguments);
    if (!wanted) return wanted.error();
    options.features = *wanted;
    options.uniforms = uniforms(arguments.uniforms);
    options.isResolved = !arguments.withConditionals;
    options.lights = arguments.lights.has_value();
    if (options.uniforms == GlslUniforms::plain && arguments.materials != 1) {
        return Error{"--materials: expected 1 with --uniforms plain, got " + std::to_string(arguments.materials)};
    }
    if (arguments.complete) {
        if (options.uniforms == GlslUniforms::none) {
            return Error{"--uniforms: expected block or plain with --complete, got none: a whole shader needs its material"};
        }
        Result<std::string> text = completeShader(options);
        if (!text) return ofGlsl(text.error());
        return text->insert(text->find('\n') + 1, heading(options, true));  // nothing may stand before #version
    }
    Result<std::string> text = glslChunk(options);
    if (!text) return ofGlsl(text.error());
    return heading(options, false) + *text;
}

// The line that names what is wrong, and the exit status: 2 for what was asked, 1 for what could not be done.
int fail(int status, std::string message)
{
    std::replace(message.begin(), message.end(), '\n', ' ');  // a name may hold one
    std::cerr << "nacre-glsl: " << message << '\n';
    return status;
}

Outcome print(const std::string& text)
{
    errno = 0;
    const bool isWritten = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (isWritten) return std::monostate{};
    return Error{"cannot write to standard output: " + std::generic_category().message(errno ? errno : EIO)};
}

int run(const Arguments& arguments)
{
    if (arguments.list) {
        const Outcome printed = print(list());
        return printed ? 0 : fail(1, printed.error().message);
    }
    if (arguments.out) {
        if (Outcome place = checkPlace(*arguments.out); !place) return fail(2, "--out: " + place.error().message);
    }
    const Result<std::string> text = shader(arguments);
    if (!text) return fail(2, text.error().message);
    const Outcome written = arguments.out ? replaceFile(*arguments.out, text->data(), text->size()) : print(*text);
    return written ? 0 : fail(1, written.error().message);
}

void addOptions(CLI::App& app, Arguments& arguments)
{
    auto* const features = app.add_option("--features", arguments.features, "Instead of a material: what the shader computes, NAME,NAME,...; --list names them");
    app.add_option("--preset", arguments.preset, "A picture of the paper, whose material the shader is for; --list names them")->excludes(features);
    app.add_option("--error", arguments.options.error, "Error of a pixel that is accepted, display white 1")->excludes(features)->capture_default_str();
    app.add_option("--machine", arguments.machine, "What the shader will run on")
        ->check(CLI::IsMember({"gpu", "cpu"}))
        ->excludes(features)
        ->capture_default_str();
    app.add_option("--fringes", arguments.fringes, "Of quality physical")
        ->check(CLI::IsMember({"table", "sampler-free"}))
        ->excludes(features)
        ->capture_default_str();
    auto* const map = app.add_flag("--thickness-map", arguments.options.thicknessMap, "The thickness is the host's, per pixel")->excludes(features);
    app.add_flag("--lower-normal-map", arguments.options.lowerNormalMap, "So is the lower normal")->needs(map);
    app.add_option("--lights", arguments.lights, "With functions and block for so many lights; with --complete 4 if not given");
    app.add_option("--materials", arguments.materials, "So many materials in the block")->capture_default_str();
    app.add_option("--version", arguments.version, "330, 400 to 460, '300 es', '310 es', '320 es', '450 vulkan', '460 vulkan'")->capture_default_str();
    app.add_option("--uniforms", arguments.uniforms, "How the material arrives")->check(CLI::IsMember({"block", "plain", "none"}))->capture_default_str();
    app.add_flag("--with-conditionals", arguments.withConditionals, "Keep #if and #line, instead of the variant's own text");
    app.add_flag("--complete", arguments.complete, "A whole fragment shader, instead of functions for one");
    app.add_option("--out", arguments.out, "File to write, instead of standard output");
    app.add_flag("--list", arguments.list, "List presets and features");
    arguments.material.addTo(app);
}

}  // namespace

int main(int argc, char** argv)
{
    Arguments arguments;
    CLI::App app{"Prints nacre's GLSL for a material, to be compiled by an engine that takes text.", "nacre-glsl"};
    addOptions(app, arguments);
    if (const std::optional<int> status = parseCommandLine(app, argc, argv)) return *status;
    try {
        return run(arguments);
    } catch (const std::exception& exception) {
        return fail(1, std::string("cannot go on: ") + exception.what());
    }
}
