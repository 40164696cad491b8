#pragma once

#include <imgui.h>

#include "log.hpp"
#include "render/renderer.hpp"
#include "scene_view.hpp"

namespace nacre::demo {

/// A window beside the mouse with the pixel under it, enlarged with its neighbours, its value, and the terms of the model at
/// that point for the key light in double precision. mouse: in the picture, pixels from its upper left corner;
/// corner, size: of the picture in the window.
void magnifier(const SceneView& view, const Renderer& renderer, ImVec2 mouse, ImVec2 corner, ImVec2 size, Log& log);

}  // namespace nacre::demo
