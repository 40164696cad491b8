#include "window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

namespace nacre::demo {
namespace {

std::string lastGlfwError()
{
    const char* description = nullptr;
    glfwGetError(&description);
    return description ? description : "no reason given";
}

Window& of(GLFWwindow* window)
{
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

}  // namespace

Result<std::unique_ptr<Window>> Window::create(const WindowOptions& options)
{
    if (!glfwInit()) return Error{"no display: " + lastGlfwError()};
    std::unique_ptr<Window> created(new Window);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debugGl ? GLFW_TRUE : GLFW_FALSE);
    // The scene is drawn into textures: the window itself needs no depth and no samples.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, options.scale > 0.0 ? GLFW_FALSE : GLFW_TRUE);
    const double factor = options.scale > 0.0 ? options.scale : 1.0;
    const auto scaled = [&](int length) { return std::max(static_cast<int>(length * factor), 1); };
    created->window_ = glfwCreateWindow(scaled(options.size.width), scaled(options.size.height), "nacre-view", nullptr, nullptr);
    if (!created->window_) return Error{"no OpenGL 3.3 window: " + lastGlfwError()};
    created->scale_ = options.scale;
    glfwMakeContextCurrent(created->window_);
    Result<GlFunctions> functions = GlFunctions::load(glfwGetProcAddress);
    if (!functions) return functions.error();
    created->gl_ = *functions;
    glfwSwapInterval(1);
    if (options.debugGl) {
        const auto callback = reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(glfwGetProcAddress("glDebugMessageCallback"));
        if (!callback || !glfwExtensionSupported("GL_KHR_debug")) return Error{"the OpenGL driver has no debug output (GL_KHR_debug)"};
        created->gl_.Enable(GL_DEBUG_OUTPUT);
        created->gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        callback(&Window::onGlMessage, created.get());
    }
    created->watch();
    return created;
}

// GLFW is not terminated: that would unload the driver, which keeps threads and exit handlers of its own.
Window::~Window()
{
    if (window_) glfwDestroyWindow(window_);
}

void Window::watch()
{
    glfwSetWindowUserPointer(window_, this);
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { of(w).events_.any = true; });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { of(w).events_.any = true; });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { of(w).events_.any = true; });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { of(w).events_.any = true; });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned int) { of(w).events_.any = true; });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { of(w).events_.any = true; });
    glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int) { of(w).events_.any = true; });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).events_.any = true; });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).events_.any = of(w).events_.resized = true; });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { of(w).events_.any = of(w).events_.resized = true; });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int modifiers) {
        of(w).events_.any = true;
        if (action == GLFW_PRESS) of(w).events_.keys.push_back({key, modifiers});
    });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        of(w).events_.any = true;
        if (count > 0) of(w).events_.dropped = paths[count - 1];
    });
}

Size Window::framebufferSize() const
{
    Size size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return {};
    return size;
}

float Window::scale() const
{
    if (scale_ > 0.0) return static_cast<float>(scale_);
    // Where the window counts in points of several pixels each, text in points is in scale already.
    float x = 1.0F, y = 1.0F;
    int width = 0, height = 0, pixels = 0;
    glfwGetWindowContentScale(window_, &x, &y);
    glfwGetWindowSize(window_, &width, &height);
    glfwGetFramebufferSize(window_, &pixels, &height);
    const float pointSize = width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1.0F;
    return std::clamp(x / pointSize, 0.5F, 8.0F);
}

std::string Window::renderer() const
{
    const auto* name = gl_.GetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "unknown";
}

bool Window::isClosing() const
{
    return glfwWindowShouldClose(window_) != 0;
}

void Window::close()
{
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

WindowEvents Window::wait()
{
    glfwWaitEvents();
    return std::exchange(events_, {});
}

WindowEvents Window::wait(double timeoutSeconds)
{
    if (timeoutSeconds > 0.0) glfwWaitEventsTimeout(timeoutSeconds);
    else glfwPollEvents();
    return std::exchange(events_, {});
}

void Window::show()
{
    glfwSwapBuffers(window_);
}

void Window::countGlError(const std::string& message)
{
    if (glErrors_++ == 0) firstGlError_ = message;
}

void Window::collectGlErrors(const char* where)
{
    while (const GLenum error = gl_.GetError()) countGlError("error " + std::to_string(error) + " while " + where);
}

void Window::onGlMessage(GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* window)
{
    if (type != GL_DEBUG_TYPE_ERROR || source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;  // GLSL's are told where it is compiled
    const_cast<Window*>(static_cast<const Window*>(window))->countGlError(message);
}

}  // namespace nacre::demo
