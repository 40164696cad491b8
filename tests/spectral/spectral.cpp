#include "spectral.hpp"

#include <cmath>
#include <fstream>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "csv_table.hpp"
#include "data/cie1931.hpp"

namespace nacre::test {
namespace {

using Complex = std::complex<double>;

constexpr double pi = 3.141592653589793238462643;

const glm::dvec3 d65White(0.3127 / 0.3290, 1.0, (1.0 - 0.3127 - 0.3290) / 0.3290);

// Rec.709 to XYZ: ITU-R BT.709's primaries and white.
glm::dmat3 rec709ToXyz()
{
    const auto corner = [](double x, double y) { return glm::dvec3(x / y, 1.0, (1.0 - x - y) / y); };
    const glm::dmat3 corners(corner(0.64, 0.33), corner(0.30, 0.60), corner(0.15, 0.06));
    const glm::dvec3 amount = glm::inverse(corners) * d65White;
    return {corners[0] * amount.x, corners[1] * amount.y, corners[2] * amount.z};
}

Result<CsvTable> readData(const std::string& name)
{
    std::ifstream file(std::string(NACRE_SPECTRAL_DATA "/") + name);
    if (!file) return Error{"cannot open " NACRE_SPECTRAL_DATA "/" + name};
    return CsvTable::read(file);
}

// Linear between rows by a constant step; the first column is the wavelength.
double interpolated(const std::vector<double>& values, double first, double step, double wavelengthNm)
{
    const double x = std::fmin(std::fmax((wavelengthNm - first) / step, 0.0), static_cast<double>(values.size() - 1));
    const auto left = std::min(static_cast<std::size_t>(x), values.size() - 2);
    const double share = x - static_cast<double>(left);
    return values[left] * (1.0 - share) + values[left + 1] * share;
}

std::vector<double> column(const CsvTable& table, const std::string& name)
{
    std::vector<double> values;
    for (std::size_t row = 0; row < table.rows.size(); ++row) values.push_back(*number(table, row, table.find(name)));
    return values;
}

double d65Power(double wavelengthNm)
{
    static const std::vector<double> power = [] {
        Result<CsvTable> table = readData("d65.csv");
        return table ? column(*table, "power") : std::vector<double>{};
    }();
    return interpolated(power, 360.0, 5.0, wavelengthNm);
}

glm::dvec3 toLab(glm::dvec3 rgb)
{
    const glm::dvec3 ratio = rec709ToXyz() * glm::max(rgb, glm::dvec3(0.0)) / d65White;
    constexpr double edge = 6.0 / 29.0;
    const auto f = [](double t) { return t > edge * edge * edge ? std::cbrt(t) : t / (3.0 * edge * edge) + 4.0 / 29.0; };
    return {116.0 * f(ratio.y) - 16.0, 500.0 * (f(ratio.x) - f(ratio.y)), 200.0 * (f(ratio.y) - f(ratio.z))};
}

double hueDegrees(double a, double b)
{
    if (a == 0.0 && b == 0.0) return 0.0;
    const double degrees = std::atan2(b, a) * 180.0 / pi;
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

double cosDegrees(double degrees)
{
    return std::cos(degrees * pi / 180.0);
}

}  // namespace

Reflectance airy(double index, Complex substrate, double thicknessNm, double cosTheta, double wavelengthNm)
{
    const double sineSquared = 1.0 - cosTheta * cosTheta;
    // n cos θ in each medium; the root with a positive imaginary part is the wave that decays.
    const Complex outside = cosTheta, film = std::sqrt(Complex(index * index - sineSquared));
    const Complex below = std::sqrt(substrate * substrate - sineSquared);
    const Complex round = std::exp(Complex(0.0, 4.0 * pi * thicknessNm / wavelengthNm) * film);
    const auto reflected = [&](Complex a, Complex b) { return std::norm((a + b * round) / (1.0 + a * b * round)); };
    const auto amplitude = [](Complex one, Complex other) { return (one - other) / (one + other); };
    const double n2 = index * index;
    const Complex m2 = substrate * substrate;
    return {reflected(amplitude(outside, film), amplitude(film, below)),
            reflected(amplitude(n2 * outside, film), amplitude(m2 * film, n2 * below))};
}

std::function<double(double)> cauchy(double a, double bUm2)
{
    return [=](double wavelengthNm) { return a + bUm2 * 1e6 / (wavelengthNm * wavelengthNm); };
}

Observer::Observer(Illuminant illuminant)
{
    glm::dvec3 white(0.0);
    for (std::size_t i = 0; i < data::cie1931.size(); ++i) {
        const double wavelengthNm = data::cie1931FirstNm + static_cast<double>(i);
        const double power = illuminant == Illuminant::d65 ? d65Power(wavelengthNm) : 1.0;
        curves_.push_back(power * glm::dvec3(data::cie1931[i][0], data::cie1931[i][1], data::cie1931[i][2]));
        white += curves_.back();
    }
    // Bradford, rows as published.
    const glm::dvec3 rows[] = {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}};
    const glm::dmat3 cones = glm::transpose(glm::dmat3(rows[0], rows[1], rows[2]));
    const glm::dvec3 gain = (cones * d65White) / (cones * (white / white.y));
    const glm::dmat3 scale(gain.x, 0.0, 0.0, 0.0, gain.y, 0.0, 0.0, 0.0, gain.z);
    const glm::dmat3 toRgb = glm::inverse(rec709ToXyz()) * glm::inverse(cones) * scale * cones;
    for (glm::dvec3& curve : curves_) curve = toRgb * curve / white.y;
}

glm::dvec3 Observer::colour(const std::function<double(double)>& reflectance) const
{
    glm::dvec3 rgb(0.0);
    for (std::size_t i = 0; i < curves_.size(); ++i) rgb += curves_[i] * reflectance(data::cie1931FirstNm + static_cast<double>(i));
    return rgb;
}

glm::dvec3 Observer::colour(const SpectralFilm& film) const
{
    return colour([&](double wavelengthNm) {
        return airy(film.index(wavelengthNm), film.substrate(wavelengthNm), film.thicknessNm, film.cosTheta, wavelengthNm).mean();
    });
}

double Observer::channel(const SpectralFilm& film, int channel) const
{
    return colour(film)[channel];
}

double ciede2000(glm::dvec3 lab1, glm::dvec3 lab2)
{
    const auto chroma = [](double a, double b) { return std::hypot(a, b); };
    const double meanC = 0.5 * (chroma(lab1.y, lab1.z) + chroma(lab2.y, lab2.z));
    const double g = 0.5 * (1.0 - std::sqrt(std::pow(meanC, 7.0) / (std::pow(meanC, 7.0) + std::pow(25.0, 7.0))));
    const double a1 = (1.0 + g) * lab1.y, a2 = (1.0 + g) * lab2.y;
    const double c1 = chroma(a1, lab1.z), c2 = chroma(a2, lab2.z);
    const double h1 = hueDegrees(a1, lab1.z), h2 = hueDegrees(a2, lab2.z);
    const bool isGrey = c1 * c2 == 0.0;

    double turn = isGrey ? 0.0 : h2 - h1;
    if (turn > 180.0) turn -= 360.0;
    if (turn < -180.0) turn += 360.0;
    const double dL = lab2.x - lab1.x, dC = c2 - c1, dH = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * turn * pi / 180.0);

    double h = h1 + h2;
    if (!isGrey) h = std::fabs(h1 - h2) <= 180.0 ? 0.5 * h : (h < 360.0 ? 0.5 * (h + 360.0) : 0.5 * (h - 360.0));
    const double l = 0.5 * (lab1.x + lab2.x), c = 0.5 * (c1 + c2);
    const double t = 1.0 - 0.17 * cosDegrees(h - 30.0) + 0.24 * cosDegrees(2.0 * h) + 0.32 * cosDegrees(3.0 * h + 6.0) -
                     0.20 * cosDegrees(4.0 * h - 63.0);
    const double sL = 1.0 + 0.015 * (l - 50.0) * (l - 50.0) / std::sqrt(20.0 + (l - 50.0) * (l - 50.0));
    const double sC = 1.0 + 0.045 * c, sH = 1.0 + 0.015 * c * t;
    const double around = 30.0 * std::exp(-std::pow((h - 275.0) / 25.0, 2.0));
    const double rT = -2.0 * std::sqrt(std::pow(c, 7.0) / (std::pow(c, 7.0) + std::pow(25.0, 7.0))) * std::sin(2.0 * around * pi / 180.0);
    const double x = dL / sL, y = dC / sC, z = dH / sH;
    return std::sqrt(std::fmax(x * x + y * y + z * z + rT * y * z, 0.0));
}

double colourDifference(glm::dvec3 a, glm::dvec3 b)
{
    return ciede2000(toLab(a), toLab(b));
}

Result<std::function<Complex(double)>> metal(const std::string& name)
{
    Result<CsvTable> table = readData("metals.csv");
    if (!table) return table.error();
    if (table->find(name + "_n") == table->columns.size()) return Error{"metals.csv has no metal '" + name + "'"};
    const std::vector<double> n = column(*table, name + "_n"), k = column(*table, name + "_k");
    return std::function<Complex(double)>([n, k](double wavelengthNm) {
        return Complex(interpolated(n, 360.0, 10.0, wavelengthNm), interpolated(k, 360.0, 10.0, wavelengthNm));
    });
}

}  // namespace nacre::test
