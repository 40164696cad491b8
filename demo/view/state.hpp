#pragma once

#include <array>
#include <filesystem>
#include <string>

#include <nacre/material.hpp>

#include "picture_size.hpp"
#include "render/viewpoint.hpp"

namespace nacre::demo {

/// A material and what it was made from, to which its parameters are reset.
struct Look {
    std::string preset;  ///< Empty: the default material.
    Material material;
};

/// The material of a preset's name as it is declared; of an empty one the default.
Material baseOf(const std::string& preset);

bool isSame(const Material& one, const Material& other);

/// What the two sides of the picture show.
enum class Comparison {
    off,      ///< One picture.
    presets,  ///< Two looks, each with a preset and parameters of its own.
    quality,  ///< One look by quality paper and by quality physical.
    layer,    ///< One look without its layer and with it; see withoutLayer().
};

/// Everything that the user sets: what is drawn and what the export says follow from it.
struct State {
    std::filesystem::path model;
    std::array<Look, 2> looks;  ///< Left and right; one of them alone where no presets are compared.
    std::size_t edited = 1;     ///< The look that the sliders change.
    Comparison comparison = Comparison::off;
    float divider = 0.5F;  ///< Where the sides meet, over the picture's width.
    Viewpoint viewpoint;
    bool turntable = false, magnifier = false, panel = true, help = false;

    std::string pictureFile = "nacre.png";
    std::string pictureSize = "1280x720";
    std::string modelField;     ///< What is typed to be opened.
    std::string message;        ///< Empty: none.
    std::string shaderMessage;  ///< Why the shader files on disk are not what is shown.

    Look& look() { return looks[edited]; }
    const Look& look() const { return looks[edited]; }
};

/// The object bare: the layer's index is the outside's and its thickness 0, so that no boundary and no path is
/// left of it and the light meets the lower boundary, with its exponent and its tilt, alone.
Material withoutLayer(Material material);

/// What is drawn on a side, 0 left and 1 right.
Material materialOf(const State& state, std::size_t side);

/// A side's name: `figure-4`, `paper`, `without the layer`.
std::string titleOf(const State& state, std::size_t side);

}  // namespace nacre::demo
