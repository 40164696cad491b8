#include "interface.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "window.hpp"

namespace nacre::demo {
namespace {

// Letters of Western Europe, Greek for the paper's symbols, and the signs of the controls.
const ImWchar letters[] = {0x20, 0xFF, 0x370, 0x3FF, 0x2010, 0x2044, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

// Where there is no DejaVu the built-in font does, which has neither Greek nor arrows.
ImFont* font(const char* file, float pixels)
{
    ImGuiIO& io = ImGui::GetIO();
    for (const char* directory : {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu/", "/usr/share/fonts/TTF/",
                                  "/usr/share/fonts/dejavu-sans-fonts/", "/usr/share/fonts/dejavu-sans-mono-fonts/"}) {
        const std::filesystem::path path = std::filesystem::path(directory) / file;
        std::error_code ignored;
        if (std::filesystem::exists(path, ignored)) return io.Fonts->AddFontFromFileTTF(path.c_str(), pixels, nullptr, letters);
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    return io.Fonts->AddFontDefault(&config);
}

ImGuiStyle style(float scale)
{
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    style.WindowRounding = style.ChildRounding = 0.0F;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 3.0F;
    style.WindowBorderSize = 0.0F;
    style.WindowPadding = {12.0F, 10.0F};
    style.FramePadding = {6.0F, 4.0F};
    style.ItemSpacing = {8.0F, 5.0F};
    style.CellPadding = {4.0F, 3.0F};
    style.Colors[ImGuiCol_WindowBg] = {0.145F, 0.15F, 0.16F, 1.0F};
    style.Colors[ImGuiCol_PopupBg] = {0.14F, 0.145F, 0.155F, 0.98F};
    style.Colors[ImGuiCol_FrameBg] = {0.225F, 0.235F, 0.255F, 1.0F};
    style.Colors[ImGuiCol_FrameBgHovered] = {0.26F, 0.27F, 0.30F, 1.0F};
    style.Colors[ImGuiCol_FrameBgActive] = {0.30F, 0.32F, 0.36F, 1.0F};
    style.Colors[ImGuiCol_SliderGrab] = {0.29F, 0.46F, 0.55F, 1.0F};
    style.Colors[ImGuiCol_SliderGrabActive] = {0.36F, 0.56F, 0.66F, 1.0F};
    style.Colors[ImGuiCol_Button] = {0.24F, 0.33F, 0.39F, 1.0F};
    style.Colors[ImGuiCol_ButtonHovered] = {0.31F, 0.43F, 0.51F, 1.0F};
    style.Colors[ImGuiCol_ButtonActive] = {0.38F, 0.53F, 0.62F, 1.0F};
    for (const ImGuiCol part : {ImGuiCol_Tab, ImGuiCol_TabUnfocused, ImGuiCol_Header}) style.Colors[part] = {0.20F, 0.26F, 0.30F, 1.0F};
    for (const ImGuiCol part : {ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive, ImGuiCol_HeaderActive, ImGuiCol_TabHovered, ImGuiCol_HeaderHovered}) {
        style.Colors[part] = {0.27F, 0.42F, 0.50F, 1.0F};
    }
    style.Colors[ImGuiCol_CheckMark] = {0.60F, 0.82F, 0.92F, 1.0F};
    style.Colors[ImGuiCol_TitleBgActive] = {0.20F, 0.29F, 0.34F, 1.0F};
    style.Colors[ImGuiCol_TextDisabled] = {0.62F, 0.64F, 0.67F, 1.0F};
    style.ScaleAllSizes(scale);
    return style;
}

}  // namespace

Interface::Interface(const Window& window) : window_(window.handle())
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // nothing is left behind
    next_ = glfwSetKeyCallback(window_, nullptr);
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui::GetIO().UserData = this;
    glfwSetKeyCallback(window_, &Interface::onKey);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    setScale(window.scale());
}

Interface::~Interface()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

// Dear ImGui 1.86 looks at the keys once a frame: one that goes down and up within a slow frame it would never see.
void Interface::onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers)
{
    Interface& self = *static_cast<Interface*>(ImGui::GetIO().UserData);
    if (self.next_) self.next_(window, key, scancode, action, modifiers);
    self.pass({key, scancode, action, modifiers});
}

void Interface::pass(const Key& key)
{
    const bool isUnseen = std::find(pressed_.begin(), pressed_.end(), key.key) != pressed_.end();
    if (!late_.empty() || (key.action == GLFW_RELEASE && isUnseen)) {
        late_.push_back(key);
        return;
    }
    if (key.action == GLFW_PRESS) pressed_.push_back(key.key);
    ImGui_ImplGlfw_KeyCallback(window_, key.key, key.scancode, key.action, key.modifiers);
}

void Interface::catchUp()
{
    pressed_.clear();
    for (const Key& key : std::exchange(late_, {})) pass(key);
}

void Interface::setScale(float scale)
{
    if (scale == scale_) return;
    scale_ = scale;
    ImGui::GetStyle() = style(scale);
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.FontDefault = font("DejaVuSans.ttf", 14.0F * scale);
    code_ = font("DejaVuSansMono.ttf", 12.0F * scale);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Interface::begin()
{
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Interface::end()
{
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    catchUp();
}

}  // namespace nacre::demo
