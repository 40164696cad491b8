#include <nacre/fringe_table.hpp>

#include <algorithm>
#include <cmath>
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
constexpr double scale = 255.0 / 55.0, shift = 127.0 / 55.0;

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

// The path of a column: in squares, since short paths have the sharper fringes.
double pathOf(int column)
{
    const double root = static_cast<double>(column) / (FringeTable::width - 1);
    return FringeTable::rangeUm * root * root;
}

// The ratio of a row. At the ends, ±1, the sum would be infinite at one path and 0 at all others; nothing reflects so.
double ratioOf(int row)
{
    return std::clamp(2.0 * row / (FringeTable::rows - 1) - 1.0, -0.99, 0.99);
}

// F(x, q, k) for all rows of all phases. At one wavelength, with the phase φ of the path and of k together, the series is
// (1 - q²) (cos φ - q) / (1 - 2 q cos φ + q²): all orders of it.
std::vector<glm::dvec3> columnAt(const Spectrum& s, double pathUm)
{
    std::array<double, FringeTable::rows> ratios{};
    for (int row = 0; row < FringeTable::rows; ++row) ratios[static_cast<std::size_t>(row)] = ratioOf(row);
    std::vector<glm::dvec3> column(FringeTable::height, glm::dvec3(0.0));
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double wavelengthUm = (data::cie1931FirstNm + static_cast<double>(i)) / 1000.0;
        const double pathPhase = glm::two_pi<double>() * pathUm / wavelengthUm;
        for (std::size_t phase = 0; phase < FringeTable::phases; ++phase) {
            const double cosine = std::cos(pathPhase + glm::pi<double>() / FringeTable::phases * static_cast<double>(phase));
            glm::dvec3* const rows = column.data() + phase * FringeTable::rows;
            for (std::size_t row = 0; row < FringeTable::rows; ++row) {
                const double q = ratios[row], squared = q * q;
                rows[row] += s[i] * ((1.0 - squared) * (cosine - q) / (1.0 - 2.0 * q * cosine + squared));
            }
        }
    }
    return column;
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
    FringeTable table;
    table.texels_.assign(static_cast<std::size_t>(width) * height * 4, 1.0F);
    for (int x = 0; x < width; ++x) {
        const std::vector<glm::dvec3> column = columnAt(s, pathOf(x));
        // The last texel is 0: beyond the table, where it is repeated, a layer has no fringes.
        const double fade = x + 1 < width ? 1.0 : 0.0;
        for (std::size_t row = 0; row < column.size(); ++row) {
            for (int channel = 0; channel < 3; ++channel) {
                const double value = fade * column[row][channel];
                const double stored = (value + shift) / scale;
                if (!(stored >= 0.0 && stored <= 1.0)) {
                    return Error{"nacre::FringeTable::create(): expected curves whose fringes stay within -2.3 and 2.3, got " + std::to_string(value) +
                                 "; are the primaries too close to each other for this light?"};
                }
                table.texels_[(row * width + static_cast<std::size_t>(x)) * 4 + static_cast<std::size_t>(channel)] = static_cast<float>(stored);
            }
        }
    }
    return table;
}

glm::dvec3 FringeTable::look(double pathUm, double ratio, int phase) const noexcept
{
    const double x = std::sqrt(std::clamp(pathUm / rangeUm, 0.0, 1.0)) * (width - 1);
    const double y = std::clamp(0.5 * ratio + 0.5, 0.0, 1.0) * (rows - 1);
    const int left = static_cast<int>(std::fmin(x, width - 2.0)), below = static_cast<int>(std::fmin(y, rows - 2.0));
    const auto at = [&](int column, int row, int channel) {
        return static_cast<double>(texels_[((static_cast<std::size_t>(phase) * rows + static_cast<std::size_t>(row)) * width + static_cast<std::size_t>(column)) * 4 + static_cast<std::size_t>(channel)]);
    };
    glm::dvec3 f;
    for (int channel = 0; channel < 3; ++channel) {
        const auto across = [&](int row) {
            const double first = at(left, row, channel), second = at(left + 1, row, channel);
            return first + (second - first) * (x - left);
        };
        const double first = across(below), second = across(below + 1);
        f[channel] = (first + (second - first) * (y - below)) * scale - shift;
    }
    return f;
}

}  // namespace nacre
