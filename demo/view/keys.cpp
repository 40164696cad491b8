#include "keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace nacre::demo {

const std::vector<KeyBinding>& keyBindings()
{
    static const std::vector<KeyBinding> table{
        {Command::help, GLFW_KEY_F1, false, "F1", "this list"},
        {Command::panel, GLFW_KEY_TAB, false, "Tab", "panel, or the picture alone"},
        {Command::turntable, GLFW_KEY_SPACE, false, "Space", "turntable"},
        {Command::magnifier, GLFW_KEY_M, false, "M", "magnifier: a pixel, its value and its terms"},
        {Command::compare, GLFW_KEY_C, false, "C", "next comparison: off, presets, paper and physical, layer off and on"},
        {Command::resetView, GLFW_KEY_HOME, false, "Home", "camera and light as at the start"},
        {Command::picture, GLFW_KEY_S, true, "Ctrl+S", "save the picture"},
        {Command::open, GLFW_KEY_O, true, "Ctrl+O", "type a model's name to open it"},
        {Command::quit, GLFW_KEY_Q, true, "Ctrl+Q", "quit"},
    };
    return table;
}

const std::vector<MouseBinding>& mouseBindings()
{
    static const std::vector<MouseBinding> table{
        {"Left", "orbit"},
        {"Right, or Shift + left", "pan"},
        {"Wheel", "zoom"},
        {"Ctrl + left, or middle", "drag the key light"},
        {"Double click", "camera and light as at the start"},
        {"Line between two sides", "drag it"},
        {"File dropped on the window", "open it"},
    };
    return table;
}

}  // namespace nacre::demo
