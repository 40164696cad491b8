#include "magnifier.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <nacre/evaluate.hpp>

#include "numbers.hpp"
#include "render/lights.hpp"
#include "surface_point.hpp"

namespace nacre::demo {
namespace {

constexpr int reach = 5;  // pixels on each side of the one in the middle

double encoded(double linear)
{
    const double x = std::clamp(linear, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

void row(const char* name, glm::dvec3 value, const char* format = "%.4f")
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    for (int channel = 0; channel < 3; ++channel) {
        ImGui::TableNextColumn();
        ImGui::Text(format, value[channel]);
    }
}

std::string text(glm::dvec3 value)
{
    return numberText(value.r) + ',' + numberText(value.g) + ',' + numberText(value.b);
}

void enlarged(const SceneView& view, int x, int y, float em)
{
    const ImVec2 whole(static_cast<float>(view.size().width), static_cast<float>(view.size().height));
    const auto at = [&](float pixelX, float pixelY) { return ImVec2(pixelX / whole.x, pixelY / whole.y); };
    const float side = 13.0F * em, pixel = side / (2.0F * reach + 1.0F);
    const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    // OpenGL's first row is the lowest.
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(view.texture())), {side, side}, at(fx - reach, fy + reach + 1.0F), at(fx + reach + 1.0F, fy - reach));
    const ImVec2 middle(corner.x + reach * pixel, corner.y + reach * pixel);
    ImGui::GetWindowDrawList()->AddRect(middle, {middle.x + pixel, middle.y + pixel}, IM_COL32(0, 0, 0, 255), 0.0F, 0, 3.0F);
    ImGui::GetWindowDrawList()->AddRect(middle, {middle.x + pixel, middle.y + pixel}, IM_COL32(255, 255, 255, 255));
}

struct Terms {
    Surface surface;
    Evaluation key;
    glm::dvec3 all{0.0};  // by all lights: what the shader computes
};

Result<Terms> termsAt(const SurfacePoint& point, const Material& material, const SceneView& view, const FringeTable& table)
{
    const Camera& camera = view.camera();
    Result<Surface> surface = nacre::surface(material, point.normal, point.tangent, point.noisePosition);
    if (!surface) return surface.error();
    Terms terms{*surface, {}, {}};
    const glm::dvec3 towardsViewer = glm::normalize(glm::dvec3(camera.eye) - point.position);
    bool isKey = true;
    for (const Light& light : lightsOf(view.picture().viewpoint, camera)) {
        Result<Evaluation> evaluation = evaluate(material, *surface, glm::normalize(glm::dvec3(light.direction)), towardsViewer, &table);
        if (!evaluation) return evaluation.error();
        if (isKey) terms.key = *evaluation;
        isKey = false;
        terms.all += static_cast<double>(light.radiance) * evaluation->shaded;
    }
    return terms;
}

void table(const char* id, float em)
{
    ImGui::BeginTable(id, 4, ImGuiTableFlags_SizingFixedFit);
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 7.5F * em);
    for (const char* channel : {"R", "G", "B"}) ImGui::TableSetupColumn(channel, ImGuiTableColumnFlags_WidthFixed, 4.2F * em);
}

void showTerms(const Terms& terms, Log& log)
{
    const Evaluation& e = terms.key;
    ImGui::Text("Key light, double precision, d = %.1f nm", terms.surface.thicknessNm);
    table("terms", ImGui::GetFontSize());
    row("R, upper", e.R);
    row("T, lower", e.T);
    row("Phase Φ/2π", e.phi / (2.0 * glm::pi<double>()), "%.3f");
    row("Fringe cos Φ", glm::cos(e.phi), "%.3f");
    row("Specular ρ", e.rho);
    row("Diffuse ρd", e.diffuse);
    row("All lights", terms.all);
    ImGui::EndTable();
    log.state("terms", text(terms.all));
}

}  // namespace

void magnifier(const SceneView& view, const Renderer& renderer, ImVec2 mouse, ImVec2 corner, ImVec2 size, Log& log)
{
    const Size pixels = view.size();
    const int x = std::clamp(static_cast<int>(mouse.x * static_cast<float>(pixels.width) / size.x), 0, pixels.width - 1);
    const int y = pixels.height - 1 - std::clamp(static_cast<int>(mouse.y * static_cast<float>(pixels.height) / size.y), 0, pixels.height - 1);
    const float em = ImGui::GetFontSize();

    // On the side of the mouse where there is room for it.
    const ImVec2 window(22.5F * em, 30.0F * em), gap(1.5F * em, 1.5F * em);
    const bool isLeft = mouse.x + gap.x + window.x > size.x;
    const float left = std::max(isLeft ? mouse.x - gap.x - window.x : mouse.x + gap.x, 0.0F);
    const float top = std::clamp(mouse.y - 0.5F * window.y, 0.0F, std::max(size.y - window.y, 0.0F));
    ImGui::SetNextWindowPos({corner.x + left, corner.y + top});
    ImGui::SetNextWindowSize({window.x, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.94F);
    ImGui::Begin("magnifier", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    enlarged(view, x, y, em);

    const glm::dvec3 mean(view.mean(x, y));
    const SceneView::Sample sample = view.sample(x, y);
    const glm::dvec3 bytes = glm::round(255.0 * glm::dvec3(encoded(mean.r), encoded(mean.g), encoded(mean.b)));
    ImGui::SameLine();
    ImGui::Text("Pixel\n%d, %d\n\nsRGB\n%.0f, %.0f, %.0f", x, pixels.height - 1 - y, bytes.r, bytes.g, bytes.b);
    table("pixel", em);
    row("Linear", mean);
    row("Its middle", glm::dvec3(sample.colour));
    ImGui::EndTable();
    ImGui::Separator();

    const glm::dvec2 place = 2.0 * sample.place / glm::dvec2(pixels.width, pixels.height) - 1.0;
    const std::optional<SurfacePoint> point = pointAt(renderer.scene(), view.camera(), place);
    const bool isLeftSide = sample.place.x < view.picture().divider * static_cast<float>(pixels.width);
    if (!point) {
        ImGui::TextUnformatted("Background");
    } else if (const Result<Terms> terms = termsAt(*point, view.picture().materials[isLeftSide ? 0 : 1], view, renderer.fringeTable())) {
        log.state("sample", text(glm::dvec3(sample.colour)));
        showTerms(*terms, log);
    } else {
        ImGui::TextWrapped("%s", terms.error().message.c_str());
    }
    ImGui::End();
}

}  // namespace nacre::demo
