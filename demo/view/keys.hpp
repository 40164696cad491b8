#pragma once

#include <vector>

namespace nacre::demo {

enum class Command { help, panel, turntable, magnifier, compare, resetView, picture, open, quit };

/// What a key does: the one list that the viewer obeys, F1 shows and the README has.
struct KeyBinding {
    Command command;
    int key;          ///< GLFW's
    bool isControl;   ///< With Ctrl.
    const char* label;
    const char* effect;
};
const std::vector<KeyBinding>& keyBindings();

/// What the mouse does over the picture.
struct MouseBinding {
    const char* label;
    const char* effect;
};
const std::vector<MouseBinding>& mouseBindings();

}  // namespace nacre::demo
