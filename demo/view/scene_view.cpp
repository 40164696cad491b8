#include "scene_view.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "gl/program.hpp"

namespace nacre::demo {
namespace {

constexpr double slowMilliseconds = 70.0;    // above it a drag no longer follows the hand
constexpr double bandMilliseconds = 60.0;    // between two looks at the mouse
constexpr double mostFineBytes = 300e6;      // colour and depth of the fine picture

const char* const everywhere = R"(#version 330 core
void main()
{
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

// The mean of a pixel's texels, or the one texel of several pixels; then sRGB (IEC 61966-2-1).
const char* const toDisplay = R"(#version 330 core
uniform sampler2D linear;
uniform int samples, coarse;
out vec4 colour;
void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) / coarse * samples;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < samples; ++y) {
        for (int x = 0; x < samples; ++x) sum += texelFetch(linear, pixel + ivec2(x, y), 0).rgb;
    }
    vec3 mean = clamp(sum / float(samples * samples), 0.0, 1.0);
    vec3 curved = 1.055 * pow(max(mean, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
    colour = vec4(mix(curved, 12.92 * mean, lessThanEqual(mean, vec3(0.0031308))), 1.0);
}
)";

class Stopwatch {
public:
    double milliseconds() const { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Result<std::unique_ptr<SceneView>> SceneView::create(const GlFunctions& gl)
{
    std::unique_ptr<SceneView> view(new SceneView(gl));
    Result<GLuint> program = linkProgram(gl, everywhere, toDisplay);
    if (!program) return program.error();
    view->program_ = *program;
    gl.GenVertexArrays(1, &view->vertexArray_);
    gl.GenTextures(1, &view->shown_);
    gl.GenFramebuffers(1, &view->framebuffer_);
    return view;
}

SceneView::~SceneView()
{
    gl_.DeleteProgram(program_);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteTextures(1, &shown_);
    gl_.DeleteFramebuffers(1, &framebuffer_);
}

// Coarser where a drag would lag, finer again where there is time for it: a step each time, since what part of the
// time goes with the pixels is the driver's own affair.
void SceneView::keepPace()
{
    if (quickMilliseconds_ > slowMilliseconds) coarse_ = std::min(coarse_ + 1, 3);
    else if (quickMilliseconds_ < 0.3 * slowMilliseconds) coarse_ = std::max(coarse_ - 1, 1);
}

int SceneView::finest() const
{
    GLint largest = 0;
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    int samples = 3;
    const auto exceeds = [&](int n) {
        return std::max(picture_.size.width, picture_.size.height) * n > largest ||
               20.0 * picture_.size.width * picture_.size.height * n * n > mostFineBytes;
    };
    while (samples > 1 && exceeds(samples)) --samples;
    return samples;
}

Size SceneView::texels(Layout layout) const
{
    const auto across = [&](int pixels) { return (pixels * layout.samples + layout.coarse - 1) / layout.coarse; };
    return {across(picture_.size.width), across(picture_.size.height)};
}

Outcome SceneView::draw(const Renderer& renderer, const ScenePicture& picture)
{
    const bool hasNewSize = picture.size.width != picture_.size.width || picture.size.height != picture_.size.height;
    picture_ = picture;
    const float aspect = static_cast<float>(picture.size.width) / static_cast<float>(picture.size.height);
    if (!framing_ || framedAspect_ != aspect) {
        framing_ = frameScene(renderer.scene(), aspect);
        framedAspect_ = aspect;
    }
    camera_ = placeCamera(*framing_, picture.viewpoint);

    if (hasNewSize) {
        gl_.BindTexture(GL_TEXTURE_2D, shown_);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.size.width, picture.size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shown_, 0);
        fineTarget_.reset();
    }
    layout_ = {1, coarse_};
    const Size size = texels(layout_);
    if (!target_ || target_->width() != size.width || target_->height() != size.height) {
        target_ = std::make_unique<FloatTarget>(gl_, size.width, size.height);
    }
    if (!target_->isComplete()) return Error{"the driver cannot draw into float textures"};
    const Stopwatch watch;
    Outcome drawn = drawHalves(renderer, *target_, 0, size.height);
    gl_.Finish();
    quickMilliseconds_ = watch.milliseconds();
    if (draws_ > 0) keepPace();  // drivers compile in the first one
    shownSamples_ = layout_.coarse > 1 ? 0 : 1;
    restSamples_ = finest();
    fineRow_ = bandRows_ = 0;
    ++draws_;
    resolve();
    return drawn;
}

Outcome SceneView::refine(const Renderer& renderer)
{
    fineLayout_ = {restSamples_, 1};
    const Size size = texels(fineLayout_);
    if (!fineTarget_ || fineTarget_->width() != size.width || fineTarget_->height() != size.height) {
        fineTarget_ = std::make_unique<FloatTarget>(gl_, size.width, size.height);
    }
    if (!fineTarget_->isComplete()) {  // a driver without the memory keeps the quick picture
        shownSamples_ = restSamples_;
        return std::monostate{};
    }
    if (bandRows_ == 0) bandRows_ = std::max(size.height / 16, 1);
    const int until = std::min(fineRow_ + bandRows_, size.height);
    const Stopwatch watch;
    Outcome drawn = drawHalves(renderer, *fineTarget_, fineRow_, until);
    gl_.Finish();
    fineRow_ = until;
    if (watch.milliseconds() < bandMilliseconds) bandRows_ *= 2;
    if (drawn && until < size.height) return drawn;
    shownSamples_ = restSamples_;
    if (!drawn) return drawn;
    std::swap(target_, fineTarget_);
    layout_ = fineLayout_;
    resolve();
    return drawn;
}

Outcome SceneView::drawHalves(const Renderer& renderer, const FloatTarget& target, int fromRow, int toRow) const
{
    target.use();
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(0, fromRow, target.width(), toRow - fromRow);
    gl_.ClearColor(background.r, background.g, background.b, 1.0F);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const int divider = std::clamp(static_cast<int>(std::lround(picture_.divider * static_cast<float>(target.width()))), 0, target.width());
    const std::array<std::array<int, 2>, 2> columns{{{0, divider}, {divider, target.width()}}};
    Outcome outcome = std::monostate{};
    for (std::size_t side = 0; side < 2 && outcome; ++side) {
        const auto [from, to] = columns[side];
        if (from == to) continue;
        gl_.Scissor(from, fromRow, to - from, toRow - fromRow);
        outcome = renderer.draw(picture_.materials[side], picture_.viewpoint, camera_);
    }
    gl_.Disable(GL_SCISSOR_TEST);
    return outcome;
}

void SceneView::resolve()
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, picture_.size.width, picture_.size.height);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.UseProgram(program_);
    gl_.Uniform1i(gl_.GetUniformLocation(program_, "samples"), layout_.samples);
    gl_.Uniform1i(gl_.GetUniformLocation(program_, "coarse"), layout_.coarse);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, target_->colour());
    gl_.BindVertexArray(vertexArray_);
    gl_.FrontFace(GL_CCW);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.BindVertexArray(0);
}

void SceneView::present(int left, int bottom) const
{
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl_.BlitFramebuffer(0, 0, picture_.size.width, picture_.size.height, left, bottom, left + picture_.size.width,
                        bottom + picture_.size.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<float> SceneView::read(int x, int y, int width, int height) const
{
    std::vector<float> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target_->framebuffer());
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(x, y, width, height, GL_RGB, GL_FLOAT, texels.data());
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return texels;
}

SceneView::Sample SceneView::sample(int x, int y) const
{
    const auto texel = [&](int pixel) { return pixel / layout_.coarse * layout_.samples + layout_.samples / 2; };
    const std::vector<float> colour = read(texel(x), texel(y), 1, 1);
    const auto place = [&](int pixel) { return (texel(pixel) + 0.5) * layout_.coarse / layout_.samples; };
    // The target of a coarse picture reaches beyond its last pixel.
    const auto span = [&](int texels) { return static_cast<double>(texels) * layout_.coarse / layout_.samples; };
    return {{colour[0], colour[1], colour[2]},
            {place(x) * picture_.size.width / span(target_->width()), place(y) * picture_.size.height / span(target_->height())}};
}

glm::vec3 SceneView::mean(int x, int y) const
{
    const auto texel = [&](int pixel) { return pixel / layout_.coarse * layout_.samples; };
    const std::vector<float> texels = read(texel(x), texel(y), layout_.samples, layout_.samples);
    glm::vec3 sum(0.0F);
    for (std::size_t i = 0; i < texels.size(); i += 3) sum += glm::vec3(texels[i], texels[i + 1], texels[i + 2]);
    return sum / (static_cast<float>(texels.size()) / 3.0F);
}

}  // namespace nacre::demo
