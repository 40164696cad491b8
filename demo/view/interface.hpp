#pragma once

#include <imgui.h>

#include <vector>

struct GLFWwindow;

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
    bool isBehind() const { return !late_.empty(); }  ///< Another frame is due to keys that it has not seen.

private:
    struct Key {
        int key, scancode, action, modifiers;
    };
    static void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);
    void pass(const Key& key);
    void catchUp();

    GLFWwindow* window_;
    void (*next_)(GLFWwindow*, int, int, int, int) = nullptr;  // the window's own key callback
    std::vector<int> pressed_;  // since the last frame
    std::vector<Key> late_;     // a release whose press no frame has seen yet, and what came after it
    float scale_ = 0.0F;
    ImFont* code_ = nullptr;
};

}  // namespace nacre::demo
