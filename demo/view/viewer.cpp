#include "viewer.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>

#include "magnifier.hpp"
#include "material_options.hpp"
#include "models.hpp"
#include "navigation.hpp"
#include "snippet.hpp"
#include "viewpoint_options.hpp"

namespace nacre::demo {
namespace {

constexpr int settlingFrames = 3;            // what Dear ImGui takes until a change is seen everywhere
constexpr double shaderSeconds = 0.25;       // between two looks at the shader files
constexpr float turnDegreesPerSecond = 30.0F;
constexpr float panelEms = 28.0F;

double millisecondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

bool isSameView(const Viewpoint& a, const Viewpoint& b)
{
    return a.azimuthDegrees == b.azimuthDegrees && a.elevationDegrees == b.elevationDegrees && a.zoom == b.zoom && a.target == b.target &&
           a.light == b.light;
}

bool isSamePicture(const ScenePicture& a, const ScenePicture& b)
{
    return isSame(a.materials[0], b.materials[0]) && isSame(a.materials[1], b.materials[1]) && a.divider == b.divider &&
           isSameView(a.viewpoint, b.viewpoint) && a.size.width == b.size.width && a.size.height == b.size.height;
}

std::string oneDecimal(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

// Text on a dark ground, so that it is read over any picture.
void caption(ImVec2 place, const std::string& text, float alignment)
{
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = 0.35F * ImGui::GetFontSize();
    const ImVec2 corner(place.x - alignment * size.x, place.y);
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x - pad, corner.y - pad}, {corner.x + size.x + pad, corner.y + size.y + pad}, IM_COL32(0, 0, 0, 150), pad);
    ImGui::GetWindowDrawList()->AddText(corner, IM_COL32(235, 235, 235, 255), text.c_str());
}

}  // namespace

Result<std::unique_ptr<Viewer>> Viewer::create(Window& window, Log& log, State state, Scene scene, const ViewerOptions& options)
{
    Result<Renderer> renderer = Renderer::create(window.gl(), std::move(scene));
    if (!renderer) return renderer.error();
    Result<std::unique_ptr<SceneView>> view = SceneView::create(window.gl());
    if (!view) return view.error();
    return std::unique_ptr<Viewer>(new Viewer(window, log, std::move(state), *std::move(renderer), *std::move(view), options));
}

Viewer::Viewer(Window& window, Log& log, State state, Renderer renderer, std::unique_ptr<SceneView> view, const ViewerOptions& options)
    : window_(window), log_(log), state_(std::move(state)), renderer_(std::move(renderer)), view_(std::move(view)), interface_(window),
      start_(options.start), lastTurn_(options.start), driver_(window.renderer())
{
    if (options.shaders) shaders_.emplace(*options.shaders);
}

Outcome Viewer::run()
{
    framesLeft_ = settlingFrames;
    while (!window_.isClosing()) {
        obey(waitForChange());
        if (shaders_) readShaders();
        if (state_.turntable) turn();
        if (window_.framebufferSize().width < 1 || window_.framebufferSize().height < 1) continue;  // minimised
        if (framesLeft_ > 0) {
            --framesLeft_;
            if (Outcome drawn = frame(); !drawn) return drawn;
        } else if (!view_->isFine()) {
            if (Outcome drawn = view_->refine(renderer_); !drawn) return drawn;
            if (view_->isFine()) framesLeft_ = 1;
        }
    }
    return std::monostate{};
}

// Asleep unless there is something to draw.
WindowEvents Viewer::waitForChange()
{
    const Size size = window_.framebufferSize();
    const bool isSeen = size.width > 0 && size.height > 0;
    if (framesLeft_ == 0 && !state_.turntable) log_.state("settled", std::to_string(frames_));
    if (isSeen && (framesLeft_ > 0 || state_.turntable || !view_->isFine())) return window_.wait(0.0);
    log_.state("rest", std::to_string(frames_));
    return shaders_ ? window_.wait(shaderSeconds) : window_.wait();
}

void Viewer::obey(const WindowEvents& events)
{
    if (events.any) framesLeft_ = settlingFrames;
    if (events.resized) interface_.setScale(window_.scale());
    keys_ += static_cast<long>(events.keys.size());
    for (const WindowEvents::Key& press : events.keys) {
        const bool isControl = (press.modifiers & GLFW_MOD_CONTROL) != 0;
        if (press.key == GLFW_KEY_ESCAPE) state_.help = false;
        for (const KeyBinding& binding : keyBindings()) {
            if (binding.key != press.key || binding.isControl != isControl) continue;
            const bool isTyping = ImGui::GetIO().WantTextInput && !isControl && binding.command != Command::help;
            if (!isTyping) obey(binding.command);
        }
    }
    if (!events.dropped.empty()) openModel(events.dropped);
}

void Viewer::obey(Command command)
{
    switch (command) {
        case Command::help: state_.help = !state_.help; break;
        case Command::panel: state_.panel = !state_.panel; break;
        case Command::turntable: state_.turntable = !state_.turntable; break;
        case Command::magnifier: state_.magnifier = !state_.magnifier; break;
        case Command::compare: compare(state_, static_cast<Comparison>((static_cast<int>(state_.comparison) + 1) % 4)); break;
        case Command::resetView: state_.viewpoint = {}; break;
        case Command::picture: savePicture(); break;
        case Command::open: state_.panel = true; panel_.focusModelField(); break;
        case Command::quit: window_.close(); break;
    }
}

void Viewer::readShaders()
{
    Result<bool> isNew = shaders_->update();
    if (isNew && !*isNew) return;
    Outcome outcome = isNew ? renderer_.setGlsl(shaders_->files()) : Outcome(isNew.error());
    state_.shaderMessage = outcome ? "" : outcome.error().message;
    log_.event("shaders", outcome ? "good" : state_.shaderMessage);
    isStale_ = isStale_ || outcome;
    framesLeft_ = settlingFrames;
}

void Viewer::turn()
{
    const double milliseconds = std::min(millisecondsSince(lastTurn_), 250.0);  // after a pause it goes on where it was
    lastTurn_ = std::chrono::steady_clock::now();
    state_.viewpoint.azimuthDegrees = std::remainder(state_.viewpoint.azimuthDegrees + turnDegreesPerSecond * static_cast<float>(milliseconds) / 1000.0F, 360.0F);
    framesLeft_ = std::max(framesLeft_, 1);
}

Outcome Viewer::frame()
{
    const auto begin = std::chrono::steady_clock::now();
    interface_.begin();
    drawInterface();
    if (Outcome drawn = drawScene(); !drawn) return drawn;

    const GlFunctions& gl = window_.gl();
    const Size size = window_.framebufferSize();
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, size.width, size.height);
    gl.ClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    view_->present(0, size.height - view_->size().height);
    interface_.end();
    window_.collectGlErrors("drawing a frame");
    if (interface_.isBehind()) framesLeft_ = settlingFrames;
    window_.show();
    frameMilliseconds_ = millisecondsSince(begin);
    if (frames_++ == 0) log_.event("first-frame-ms", oneDecimal(millisecondsSince(start_)));
    report();
    return std::monostate{};
}

Outcome Viewer::drawScene()
{
    const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
    ScenePicture picture;
    picture.materials = {materialOf(state_, 0), materialOf(state_, 1)};
    picture.divider = state_.comparison == Comparison::off ? 0.0F : state_.divider;
    picture.viewpoint = state_.viewpoint;
    picture.size = {std::max(static_cast<int>(sceneSize_.x * pixels.x), 1), std::max(static_cast<int>(sceneSize_.y * pixels.y), 1)};
    if (!isStale_ && isSamePicture(picture, view_->picture())) return std::monostate{};
    isStale_ = false;
    return view_->draw(renderer_, picture);
}

void Viewer::drawInterface()
{
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float panel = state_.panel ? std::floor(std::min(panelEms * ImGui::GetFontSize(), 0.6F * display.x)) : 0.0F;
    sceneSize_ = {std::max(display.x - panel, 1.0F), std::max(display.y, 1.0F)};
    drawSceneArea(sceneSize_);
    if (panel > 0.0F) grant(panel_.draw(state_, {display.x - panel, 0.0F}, {panel, display.y}, interface_.codeFont(), status(), log_));
    if (state_.help) drawHelp(display);
}

void Viewer::drawSceneArea(ImVec2 size)
{
    constexpr ImGuiWindowFlags bare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBackground |
                                      ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::Begin("scene", nullptr, bare);
    ImGui::PopStyleVar();
    ImGui::InvisibleButton("picture", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    log_.widget("scene");
    const bool isHovered = ImGui::IsItemHovered();
    navigate(size);
    if (state_.comparison != Comparison::off) drawDivider(size);
    drawMessages(size);
    ImGui::End();
    const bool isDrawn = view_->draws() > 0;
    if (state_.magnifier && isHovered && isDrawn && drag_ == Drag::none) {
        magnifier(*view_, renderer_, ImGui::GetIO().MousePos, {0.0F, 0.0F}, size, log_);
    }
}

void Viewer::navigate(ImVec2 size)
{
    const ImGuiIO& io = ImGui::GetIO();
    const float divider = state_.divider * size.x;
    const bool isAtDivider = state_.comparison != Comparison::off && std::fabs(io.MousePos.x - divider) < 0.5F * ImGui::GetFontSize();
    if (ImGui::IsItemActivated()) {
        if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (ImGui::IsMouseDown(ImGuiMouseButton_Left) && io.KeyCtrl)) drag_ = Drag::light;
        else if (ImGui::IsMouseDown(ImGuiMouseButton_Right) || io.KeyShift) drag_ = Drag::pan;
        else drag_ = isAtDivider ? Drag::divider : Drag::orbit;
    }
    if (!ImGui::IsItemActive()) drag_ = Drag::none;
    if (drag_ == Drag::divider || (drag_ == Drag::none && isAtDivider && ImGui::IsItemHovered())) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);

    const float side = std::max(std::min(size.x, size.y), 1.0F);
    const glm::vec2 movement(io.MouseDelta.x / side, io.MouseDelta.y / side);
    const bool hasMoved = movement != glm::vec2(0.0F);
    if (hasMoved && drag_ == Drag::orbit) orbit(state_.viewpoint, movement);
    if (hasMoved && drag_ == Drag::pan && view_->draws() > 0) pan(state_.viewpoint, movement, view_->framing());
    if (hasMoved && drag_ == Drag::light) dragLight(state_.viewpoint, movement);
    if (drag_ == Drag::divider) state_.divider = std::clamp(io.MousePos.x / size.x, 0.0F, 1.0F);
    if (!ImGui::IsItemHovered()) return;
    if (io.MouseWheel != 0.0F) zoom(state_.viewpoint, io.MouseWheel);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) state_.viewpoint = {};
}

void Viewer::drawDivider(ImVec2 size)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize(), x = std::round(state_.divider * size.x);
    draw.AddLine({x, 0.0F}, {x, size.y}, IM_COL32(0, 0, 0, 255), 3.0F);
    draw.AddLine({x, 0.0F}, {x, size.y}, IM_COL32(255, 255, 255, 255), 1.0F);
    draw.AddCircleFilled({x, 0.5F * size.y}, 0.55F * em, IM_COL32(255, 255, 255, 255));
    draw.AddTriangleFilled({x - 0.35F * em, 0.5F * size.y}, {x - 0.1F * em, 0.5F * size.y - 0.2F * em}, {x - 0.1F * em, 0.5F * size.y + 0.2F * em}, IM_COL32(40, 40, 40, 255));
    draw.AddTriangleFilled({x + 0.35F * em, 0.5F * size.y}, {x + 0.1F * em, 0.5F * size.y - 0.2F * em}, {x + 0.1F * em, 0.5F * size.y + 0.2F * em}, IM_COL32(40, 40, 40, 255));
    draw.PushClipRect({0.0F, 0.0F}, {x, size.y}, true);
    caption({x - em, em}, titleOf(state_, 0), 1.0F);
    draw.PopClipRect();
    draw.PushClipRect({x, 0.0F}, size, true);
    caption({x + em, em}, titleOf(state_, 1), 0.0F);
    draw.PopClipRect();
}

void Viewer::drawMessages(ImVec2 size)
{
    const float em = ImGui::GetFontSize();
    float bottom = size.y - em;
    for (std::string* message : {&state_.message, &state_.shaderMessage}) {
        if (message->empty()) continue;
        const float wrap = std::max(size.x - 7.0F * em, 4.0F * em);
        const float height = std::min(ImGui::CalcTextSize(message->c_str(), nullptr, false, wrap).y + 1.4F * em, 0.7F * size.y);
        ImGui::SetNextWindowPos({em, bottom - height});
        ImGui::PushID(message);
        ImGui::PushStyleColor(ImGuiCol_ChildBg, IM_COL32(20, 20, 24, 235));
        ImGui::SetCursorPos({em, bottom - height});
        ImGui::BeginChild("message", {size.x - 2.0F * em, height}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
        if (message == &state_.message) {
            if (ImGui::SmallButton("×")) message->clear();
            log_.widget("dismiss");
            ImGui::SameLine();
        }
        ImGui::PushTextWrapPos(size.x - 3.0F * em);
        ImGui::TextUnformatted(message->c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndChild();
        ImGui::PopStyleColor();
        ImGui::PopID();
        bottom -= height + 0.5F * em;
    }
}

void Viewer::drawHelp(ImVec2 display)
{
    ImGui::SetNextWindowPos({0.5F * display.x, 0.5F * display.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::Begin("Keys and mouse", &state_.help, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize);
    const auto line = [](const char* label, const char* effect) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextColored({0.65F, 0.83F, 0.93F, 1.0F}, "%s", label);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(effect);
    };
    ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit);
    for (const KeyBinding& binding : keyBindings()) line(binding.label, binding.effect);
    ImGui::EndTable();
    ImGui::Separator();
    ImGui::BeginTable("mouse", 2, ImGuiTableFlags_SizingFixedFit);
    for (const MouseBinding& binding : mouseBindings()) line(binding.label, binding.effect);
    line("Ctrl + click on a slider", "type a value, beyond its ends too");
    line("Shift on a channel's slider", "move all three");
    ImGui::EndTable();
    ImGui::End();
}

void Viewer::grant(const PanelRequests& requests)
{
    if (requests.openModel) openModel(*requests.openModel);
    if (requests.savePicture) savePicture();
    if (requests.saveGlsl) saveGlsl();
    if (requests.resetView) state_.viewpoint = {};
}

void Viewer::openModel(const std::string& file)
{
    Result<Scene> scene = loadScene(file);
    Outcome opened = scene ? renderer_.setScene(*std::move(scene)) : Outcome(scene.error());
    state_.message = opened ? "" : opened.error().message;
    log_.event(opened ? "opened" : "refused", opened ? file : state_.message);
    framesLeft_ = settlingFrames;
    if (!opened) return;
    view_->sceneChanged();
    isStale_ = true;
    state_.model = file;
    state_.modelField.clear();
    state_.viewpoint = {};
}

void Viewer::savePicture()
{
    const auto save = [&]() -> Outcome {
        Result<Size> size = parseSize(state_.pictureSize);
        if (!size) return size.error();
        if (Outcome writable = checkWritable(state_.pictureFile); !writable) return writable;
        Result<Image> image = renderer_.render(state_.look().material, size->width, size->height, state_.viewpoint);
        if (!image) return image.error();
        return writeImage(*image, state_.pictureFile);
    };
    Outcome saved = std::monostate{};
    try {
        saved = save();
    } catch (const std::exception& exception) {  // memory ends where a picture is large enough
        saved = Error{std::string("no picture: ") + exception.what()};
    }
    state_.message = saved ? "Saved " + state_.pictureFile + ", " + state_.pictureSize : saved.error().message;
    log_.event(saved ? "saved" : "refused", saved ? renderCommand(state_) : state_.message);
    framesLeft_ = settlingFrames;
}

void Viewer::saveGlsl()
{
    const std::filesystem::path file = std::filesystem::path(state_.pictureFile).replace_extension(".glsl");
    Result<Needs> needs = needsOf(state_.look().material);
    std::ofstream stream(file, std::ios::binary);
    if (needs) stream << needs->glsl;
    stream.close();
    const bool isWritten = needs && stream;
    state_.message = !needs ? needs.error().message : (isWritten ? "Saved " : "cannot write '") + file.string() + (isWritten ? "" : "'");
    log_.event(isWritten ? "saved-glsl" : "refused", isWritten ? file.string() : state_.message);
}

std::string Viewer::status() const
{
    const Size size = view_->size();
    const auto square = [](int side) { return std::to_string(side) + 'x' + std::to_string(side); };
    const std::string samples = view_->samples() > 0 ? square(view_->samples()) + " samples a pixel" : "coarse";
    return "Scene " + oneDecimal(view_->quickMilliseconds()) + " ms, " + std::to_string(size.width) + "x" + std::to_string(size.height) + ", now " +
           samples + "\nFrame " + oneDecimal(frameMilliseconds_) + " ms; " + driver_;
}

// For who drives the viewer by its log: what it shows after this frame.
void Viewer::report()
{
    if (!log_.isOn()) return;
    const ImGuiIO& io = ImGui::GetIO();
    const auto whole = [](float value) { return std::to_string(static_cast<int>(value)); };
    const Size size = window_.framebufferSize();
    log_.state("frame", std::to_string(frames_));  // first: who reads another line knows of the frame
    log_.state("window", std::to_string(size.width) + 'x' + std::to_string(size.height));
    log_.state("mouse", whole(io.MousePos.x) + ' ' + whole(io.MousePos.y) + ' ' + (io.MouseDown[0] ? "1" : "0") + (io.MouseDown[1] ? "1" : "0") + (io.MouseDown[2] ? "1" : "0"));
    const bool isHeld = std::any_of(std::begin(io.KeysDown), std::end(io.KeysDown), [](bool isDown) { return isDown; });
    log_.state("keys", std::to_string(keys_) + (isHeld ? " held" : ""));
    log_.state("preset", state_.look().preset.empty() ? "default" : state_.look().preset);
    log_.state("material", optionsText(state_.look().material, Material{}));
    log_.state("viewpoint", optionsText(state_.viewpoint));
    log_.state("comparison", std::to_string(static_cast<int>(state_.comparison)) + ' ' + std::to_string(state_.divider));
    log_.state("help", state_.help ? "1" : "0");
    log_.state("magnifier", state_.magnifier ? "1" : "0");
    log_.state("text:model", state_.modelField);
    log_.state("text:picture-file", state_.pictureFile);
    log_.state("text:picture-size", state_.pictureSize);
    log_.state("typing", io.WantTextInput ? "1" : "0");
    log_.state("draws", std::to_string(view_->draws()));
    log_.state("scene-ms", oneDecimal(view_->quickMilliseconds()) + ' ' + std::to_string(view_->coarse()));
    log_.state("frame-ms", oneDecimal(frameMilliseconds_));
    log_.state("samples", std::to_string(view_->samples()));
    log_.state("gl-errors", std::to_string(window_.glErrors()));
}

}  // namespace nacre::demo
