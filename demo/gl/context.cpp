#include "context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <string_view>

namespace nacre::demo {
namespace {

// Declared here, since Mesa 25.1 took <GL/osmesa.h> away with the library: osmesa.h of Mesa 22.
namespace osmesa {
constexpr int format = 0x22;
constexpr int depthBits = 0x30;
constexpr int profile = 0x33;
constexpr int coreProfile = 0x34;
constexpr int majorVersion = 0x36;
constexpr int minorVersion = 0x37;
constexpr int rgba = 0x1908;
using CreateContextAttribs = void* (*)(const int* attributes, void* share);
using DestroyContext = void (*)(void* context);
using MakeCurrent = unsigned char (*)(void* context, void* buffer, unsigned int type, int width, int height);
}  // namespace osmesa

// A shared library that stays open: drivers keep threads and exit handlers of their own.
void* open(std::string_view name)
{
    return dlopen(std::string(name).c_str(), RTLD_NOW | RTLD_LOCAL);
}

template <class Function>
bool find(void* library, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

struct OsmesaHandle {
    void* context = nullptr;
    osmesa::DestroyContext destroy = nullptr;
    std::array<unsigned char, 4> buffer{};  // OSMesa wants one; nothing is drawn to it

    ~OsmesaHandle()
    {
        if (context) destroy(context);
    }
};

struct EglHandle {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    PFNEGLMAKECURRENTPROC makeCurrent = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroyContext = nullptr;

    // The display is not terminated: whoever else in the process asks for it gets the same one.
    ~EglHandle()
    {
        if (context) {
            makeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            destroyContext(display, context);
        }
    }
};

}  // namespace

Result<Context> Context::create(ContextKind kind)
{
    if (kind == ContextKind::any) {
        const char* wish = std::getenv("NACRE_CONTEXT");
        const std::string_view name = wish ? wish : "";
        if (name == "osmesa") kind = ContextKind::osmesa;
        else if (name == "egl") kind = ContextKind::egl;
        else if (!name.empty()) return Error{"NACRE_CONTEXT: expected osmesa or egl, got '" + std::string(name) + "'"};
    }
    if (kind == ContextKind::osmesa) return createOsmesa();
    if (kind == ContextKind::egl) return createEgl();

    Result<Context> first = createOsmesa();
    if (first) return first;
    Result<Context> second = createEgl();
    if (second) return second;
    return Error{"no OpenGL context: " + first.error().message + "; " + second.error().message};
}

Result<Context> Context::createOsmesa()
{
    void* library = open("libOSMesa.so.8");
    if (!library) library = open("libOSMesa.so.6");
    if (!library) return Error{"OSMesa: no libOSMesa.so (Debian 12: package libosmesa6)"};

    osmesa::CreateContextAttribs createContext = nullptr;
    osmesa::MakeCurrent makeCurrent = nullptr;
    Context context;
    auto handle = std::make_shared<OsmesaHandle>();
    if (!find(library, "OSMesaCreateContextAttribs", createContext) || !find(library, "OSMesaMakeCurrent", makeCurrent) ||
        !find(library, "OSMesaDestroyContext", handle->destroy) ||
        !find(library, "OSMesaGetProcAddress", context.getProcAddress_)) {
        return Error{"OSMesa: libOSMesa.so is older than Mesa 11, which brought OSMesaCreateContextAttribs"};
    }
    const int attributes[] = {osmesa::format, osmesa::rgba, osmesa::depthBits, 0, osmesa::profile, osmesa::coreProfile,
                              osmesa::majorVersion, 3, osmesa::minorVersion, 3, 0};
    handle->context = createContext(attributes, nullptr);
    if (!handle->context) return Error{"OSMesa: no OpenGL 3.3 core context"};
    if (!makeCurrent(handle->context, handle->buffer.data(), GL_UNSIGNED_BYTE, 1, 1)) {
        return Error{"OSMesa: the context cannot be made current"};
    }
    context.handle_ = handle;
    context.kind_ = "OSMesa";
    return std::move(context).withFunctions();
}

Result<Context> Context::createEgl()
{
    void* library = open("libEGL.so.1");
    if (!library) return Error{"EGL: no libEGL.so.1 (Debian 12: packages libegl1, libgl1-mesa-dri)"};

    PFNEGLGETPROCADDRESSPROC getProcAddress = nullptr;
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLBINDAPIPROC bindApi = nullptr;
    PFNEGLCREATECONTEXTPROC createContext = nullptr;
    auto handle = std::make_shared<EglHandle>();
    if (!find(library, "eglGetProcAddress", getProcAddress) || !find(library, "eglInitialize", initialize) ||
        !find(library, "eglBindAPI", bindApi) || !find(library, "eglCreateContext", createContext) ||
        !find(library, "eglMakeCurrent", handle->makeCurrent) || !find(library, "eglDestroyContext", handle->destroyContext)) {
        return Error{"EGL: libEGL.so.1 lacks a function of EGL 1.5"};
    }
    const auto getPlatformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(getProcAddress("eglGetPlatformDisplayEXT"));
    if (!getPlatformDisplay) return Error{"EGL: no eglGetPlatformDisplayEXT"};
    handle->display = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (!handle->display || !initialize(handle->display, nullptr, nullptr)) {
        handle->display = EGL_NO_DISPLAY;
        return Error{"EGL: no surfaceless display (Debian 12: package libgl1-mesa-dri)"};
    }
    if (!bindApi(EGL_OPENGL_API)) return Error{"EGL: no desktop OpenGL"};
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    handle->context = createContext(handle->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (!handle->context) return Error{"EGL: no OpenGL 3.3 core context"};
    if (!handle->makeCurrent(handle->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle->context)) {
        return Error{"EGL: the context cannot be made current"};
    }
    Context context;
    context.handle_ = handle;
    context.getProcAddress_ = getProcAddress;
    context.kind_ = "EGL";
    return std::move(context).withFunctions();
}

Result<Context> Context::withFunctions() &&
{
    Result<GlFunctions> functions = GlFunctions::load(getProcAddress_);
    if (!functions) return Error{kind_ + ": " + functions.error().message};
    gl_ = *functions;
    return std::move(*this);
}

std::string Context::renderer() const
{
    const auto* name = gl_.GetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "unknown";
}

}  // namespace nacre::demo
