#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nacre/result.hpp>

namespace nacre::demo {

/// Linear Rec.709 colours, three floats per pixel, the top row first.
struct Image {
    int width = 0, height = 0;
    std::vector<float> pixels;
};

/// An error where a file of that name cannot become a picture: its ending is neither .png nor .exr, or
/// there is no such directory. Asked before the work, so that none is done in vain.
Outcome checkWritable(const std::filesystem::path& file);

/// Writes .png as sRGB, 8 bits, or .exr as linear float. The file appears whole or not at all.
Outcome writeImage(const Image& image, const std::filesystem::path& file);

/// Averages squares of factor × factor pixels.
Image shrink(const Image& image, int factor);

/// The images in rows of `columns`, each with its label below.
struct LabelledImage {
    Image image;
    std::string label;
};
Image contactSheet(const std::vector<LabelledImage>& images, int columns);

}  // namespace nacre::demo
