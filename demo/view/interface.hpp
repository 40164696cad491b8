#pragma once

#include <imgui.h>

namespace nacre::demo {

class Window;

/// Dear ImGui on a window: fonts and style in its scale, frames.
class Interface {
public:
    explicit Interface(const Window& window);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// Fonts and style for another scale, where it is another.
    void setScale(float scale);
    float scale() const { return scale_; }
    ImFont* codeFont() const { return code_; }

    void begin();
    void end();  ///< Draws into the framebuffer of the window.

private:
    float scale_ = 0.0F;
    ImFont* code_ = nullptr;
};

}  // namespace nacre::demo
