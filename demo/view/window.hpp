#pragma once

#include <memory>
#include <string>
#include <vector>

#include <nacre/result.hpp>

#include "gl/functions.hpp"
#include "picture_size.hpp"

struct GLFWwindow;

namespace nacre::demo {

struct WindowOptions {
    Size size{1280, 720};    ///< Before scaling.
    double scale = 0.0;      ///< Of text and controls; 0: the display's.
    bool debugGl = false;    ///< A debug context, whose errors are counted.
};

/// What happened to the window since it was last asked.
struct WindowEvents {
    bool any = false;        ///< Something that a frame could show.
    bool resized = false;
    std::string dropped;     ///< The last file that was dropped on it.
    struct Key {
        int key, modifiers;
    };
    std::vector<Key> keys;   ///< That went down, GLFW's.
};

/// A window with an OpenGL 3.3 core context that is current.
class Window {
public:
    /// The error says what the display or the driver lacks.
    static Result<std::unique_ptr<Window>> create(const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    const GlFunctions& gl() const { return gl_; }
    GLFWwindow* handle() const { return window_; }
    Size framebufferSize() const;  ///< 0x0 while minimised.
    /// Text and controls over their size on a display of 96 dots per inch.
    float scale() const;
    std::string renderer() const;  ///< The driver's own name.
    bool isClosing() const;
    void close();

    /// Waits for events; with a timeout no longer than that many seconds, 0: not at all.
    WindowEvents wait();
    WindowEvents wait(double timeoutSeconds);
    void show();  ///< What was drawn.

    /// Errors that a debug context reported, and the first of them.
    int glErrors() const { return glErrors_; }
    const std::string& firstGlError() const { return firstGlError_; }
    /// Adds what glGetError() holds.
    void collectGlErrors(const char* where);

private:
    Window() = default;
    void watch();
    void countGlError(const std::string& message);
    static void APIENTRY onGlMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* message,
                                     const void* window);

    GLFWwindow* window_ = nullptr;
    GlFunctions gl_;
    double scale_ = 0.0;
    WindowEvents events_;
    int glErrors_ = 0;
    std::string firstGlError_;
};

}  // namespace nacre::demo
