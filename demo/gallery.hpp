#pragma once

#include <filesystem>
#include <functional>

#include <nacre/result.hpp>

#include "render/renderer.hpp"

namespace nacre::demo {

/// Every preset as DIRECTORY/NAME.png and all of them as DIRECTORY/contact-sheet.png. Makes the directory.
/// progress is called with what is done and what there is to do, after each file.
Outcome writeGallery(const Renderer& renderer, const Viewpoint& viewpoint, const std::filesystem::path& directory,
                     int width, int height, const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace nacre::demo
