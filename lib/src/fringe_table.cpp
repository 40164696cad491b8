#include <nacre/fringe_table.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "data/cie1931.hpp"

namespace nacre {
namespace {

using Spectrum = std::array<glm::dvec3, data::cie1931.size()>;

// nacre_fringeTexel's code and back.
constexpr double scale = 255.0 / 64.0;

glm::dvec3 toXyz(glm::dvec2 xy)
{
    return {xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y};
}

// The columns are the primaries' tristimulus values, scaled so that they add up to the white.
glm::dmat3 rgbToXyz(const FringeOptions& o)
{
    const glm::dmat3 primaries(toXyz(o.red), toXyz(o.green), toXyz(o.blue));
    const glm::dvec3 amounts = glm::inverse(primaries) * toXyz(o.white);
    return {primaries[0] * amounts[0], primaries[1] * amounts[1], primaries[2] * amounts[2]};
}

// Von Kries' adaptation in the cone space of Lam & Rigg, "Bradford".
glm::dmat3 adaptation(glm::dvec3 from, glm::dvec3 to)
{
    const glm::dmat3 cones = glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
    const glm::dvec3 gain = (cones * to) / (cones * from);
    return glm::inverse(cones) * glm::dmat3(gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z) * cones;
}

// The sensor's curves times the light, each with the sum 1.
Spectrum curves(const FringeOptions& o)
{
    Spectrum s;
    glm::dvec3 white(0.0);
    for (std::size_t i = 0; i < s.size(); ++i) {
        const auto& xyz = data::cie1931[i];
        s[i] = glm::dvec3(xyz[0], xyz[1], xyz[2]) * (o.light.empty() ? 1.0 : o.light[i]);
        white += s[i];
    }
    const glm::dmat3 toRgb = glm::inverse(rgbToXyz(o)) * adaptation(white / white.y, toXyz(o.white));
    for (glm::dvec3& value : s) value = toRgb * (value / white.y);
    return s;
}

// What one texel holds: C of three channels and of the luminance.
struct Fringes {
    std::array<std::complex<double>, 3> channel{};
    std::complex<double> luminance;
};

Fringes fringesAt(const Spectrum& s, glm::dvec3 luminance, double pathUm)
{
    Fringes f;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double wavelengthUm = (data::cie1931FirstNm + static_cast<double>(i)) / 1000.0;
        const std::complex<double> wave = std::polar(1.0, glm::two_pi<double>() * pathUm / wavelengthUm);
        for (int channel = 0; channel < 3; ++channel) f.channel[static_cast<std::size_t>(channel)] += s[i][channel] * wave;
        f.luminance += dot(luminance, s[i]) * wave;
    }
    return f;
}

bool isChromaticity(glm::dvec2 xy)
{
    return std::isfinite(xy.x) && std::isfinite(xy.y) && xy.y > 0.0;
}

std::string faultOf(const FringeOptions& o)
{
    if (!isChromaticity(o.red) || !isChromaticity(o.green) || !isChromaticity(o.blue) || !isChromaticity(o.white)) {
        return "expected finite chromaticities with y > 0";
    }
    if (std::fabs(glm::determinant(glm::dmat3(toXyz(o.red), toXyz(o.green), toXyz(o.blue)))) < 1e-6) {
        return "expected three primaries that are not on one line";
    }
    if (o.light.empty()) return {};
    if (o.light.size() != data::cie1931.size()) {
        return "expected a light of 471 values or none, got " + std::to_string(o.light.size());
    }
    const auto isPower = [](double power) { return power >= 0.0 && std::isfinite(power); };
    if (!std::all_of(o.light.begin(), o.light.end(), isPower)) return "expected a light of finite values >= 0";
    if (!std::any_of(o.light.begin() + 40, o.light.begin() + 340, [](double power) { return power > 0.0; })) {
        return "expected a light that is not dark from 400 to 700 nm";
    }
    return {};
}

}  // namespace

Result<FringeTable> FringeTable::create(const FringeOptions& options)
{
    if (const std::string fault = faultOf(options); !fault.empty()) return Error{"nacre::FringeTable::create(): " + fault};
    const Spectrum s = curves(options);
    const glm::dmat3 primaries = rgbToXyz(options);
    const glm::dvec3 luminance(primaries[0].y, primaries[1].y, primaries[2].y);

    FringeTable table;
    table.texels_.resize(static_cast<std::size_t>(width) * height * 4);
    for (int x = 0; x < width; ++x) {
        // The last texel is 0: beyond the table, where it is repeated, a layer has no fringes.
        const Fringes f = x + 1 < width ? fringesAt(s, luminance, rangeUm * x / (width - 1)) : Fringes{};
        for (int row = 0; row < height; ++row) {
            for (std::size_t channel = 0; channel < 4; ++channel) {
                const std::complex<double> c = channel < 3 ? f.channel[channel] : std::abs(f.luminance);
                const double part = row == 0 || channel == 3 ? c.real() : c.imag();
                const double stored = (part + 2.0) / scale;
                if (!(stored >= 0.0 && stored <= 1.0)) {
                    return Error{"nacre::FringeTable::create(): expected curves whose fringes stay within -2 and 1.98, got " + std::to_string(part) +
                                 "; are the primaries too close to each other for this light?"};
                }
                table.texels_[(static_cast<std::size_t>(row) * width + static_cast<std::size_t>(x)) * 4 + channel] = static_cast<float>(stored);
            }
        }
    }
    return table;
}

std::vector<std::uint8_t> FringeTable::bytes() const
{
    std::vector<std::uint8_t> bytes(texels_.size());
    std::transform(texels_.begin(), texels_.end(), bytes.begin(),
                   [](float texel) { return static_cast<std::uint8_t>(std::lround(texel * 255.0F)); });
    return bytes;
}

glm::dvec4 FringeTable::look(double pathUm, Row row) const noexcept
{
    const double x = std::fmin(std::fmax(pathUm, 0.0) / rangeUm, 1.0) * (width - 1);
    const auto left = static_cast<std::size_t>(std::fmin(std::floor(x), width - 2.0));
    const double share = x - static_cast<double>(left);
    const float* a = texels_.data() + (static_cast<std::size_t>(row) * width + left) * 4;
    glm::dvec4 c;
    for (int channel = 0; channel < 4; ++channel) {
        const double first = static_cast<double>(a[channel]), second = static_cast<double>(a[channel + 4]);
        c[channel] = (first + (second - first) * share) * scale - 2.0;
    }
    return c;
}

}  // namespace nacre
