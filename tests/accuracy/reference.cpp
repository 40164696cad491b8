#include "reference.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace nacre::test {
namespace {

constexpr std::size_t count = std::tuple_size_v<Components>;
using Numbers = std::array<double, count>;

// The distance from a number to the next one away from 0. A 0 is meant: the model jumps between an exponent of
// 0 and the smallest one above.
double ulp(float value)
{
    if (value == 0.0F) return 0.0;
    const float magnitude = std::fabs(value);
    return static_cast<double>(std::nextafter(magnitude, std::numeric_limits<float>::infinity())) - static_cast<double>(magnitude);
}

// An input whose numbers are not float32. Light and view stay as long as they are: that a float32 direction is
// a unit vector but for its rounding is part of what is uncertain.
struct Moved {
    nacre::Material material;
    glm::dvec3 light, view;
    model::Surface surface;
};

Moved moved(const Numbers& n)
{
    const auto vector = [&](std::size_t first) { return glm::dvec3(n[first], n[first + 1], n[first + 2]); };
    const auto notNegative = [&](std::size_t i) { return std::fmax(n[i], 0.0); };
    Moved m;
    m.light = vector(0);
    m.view = vector(3);
    m.surface = {vector(6), vector(9), notNegative(thicknessComponent)};
    m.material.ior = vector(12);
    m.material.upperExponent = notNegative(16);
    m.material.lowerExponent = notNegative(17);
    m.material.iorOutside = n[18];
    m.material.wavelengthNm = vector(19);
    return m;
}

Reference evaluate(const model::Material& m, const model::Surface& s, glm::dvec3 light, glm::dvec3 view)
{
    const model::View w = model::view(m, s, view);
    // The coefficient is the layer's wherever the viewer is; seen from above, so that no rounding hides it.
    return {model::specular(m, w, light), model::view(m, s, model::direction(s.upperNormal)).diffuse};
}

Reference evaluate(const Numbers& numbers)
{
    const Moved m = moved(numbers);
    return evaluate(model::derive(m.material), m.surface, m.light, m.view);
}

// The quantities of one channel at whose zero the model jumps, or has an infinite slope: both horizons, both
// thresholds of total reflection, the null conditions under Eq 10, and the upper lobe's zero.
using Switches = std::array<double, 8>;

Switches switches(const Numbers& numbers, int channel)
{
    const Moved moved_ = moved(numbers);
    const model::Material m = model::derive(moved_.material);
    const model::View w = model::view(m, moved_.surface, moved_.view);
    const double cosThetaI = dot(w.upperNormal, moved_.light);
    const double cosThetaO = dot(w.upperNormal, moved_.view);
    const glm::dvec3 halfVector = moved_.light + moved_.view;
    const glm::dvec3 squaredI = model::refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosThetaI);
    const glm::dvec3 squaredO = model::refractedCosineSquared(m.etaSquared, m.oneMinusEtaSquared, cosThetaO);
    const glm::dvec3 insideI = sqrt(max(squaredI, 0.0)), insideO = sqrt(max(squaredO, 0.0));
    const glm::dvec3 lowerI = model::lowerCosine(m.eta, w.cosBetween, cosThetaI, dot(w.lowerNormal, moved_.light), insideI);
    const glm::dvec3 lowerO = model::lowerCosine(m.eta, w.cosBetween, cosThetaO, dot(w.lowerNormal, moved_.view), insideO);
    const glm::dvec2 halfAcross(dot(w.frameX, halfVector), dot(w.frameY, halfVector));
    const glm::dvec3 lower = model::lowerLobeOneMinus(m.eta, halfAcross, w.upperAcross, cosThetaI + cosThetaO, insideI + insideO, lowerI - lowerO);
    const double upper = model::upperLobeOneMinus(w.upperNormal, halfVector, cosThetaI, cosThetaO);
    return {cosThetaI, cosThetaO, squaredI[channel], squaredO[channel], lowerI[channel], lowerO[channel], 1.0 - lower[channel],
            1.0 - upper};
}

// Grows the range by one evaluation after the other.
class Explorer {
public:
    Explorer(const Input& input, int channel, int ulps) : channel_(channel)
    {
        const Components floats = components(input);
        for (std::size_t i = 0; i < count; ++i) {
            nominal_[i] = floats[i];
            step_[i] = ulps * ulp(floats[i]);
        }
        range_.least = range_.most = evaluate(nominal_).rho[channel];
        range_.crossesJump = false;
        switches_ = switches(nominal_, channel);
    }

    bool reaches(double value, double tolerance) const
    {
        return value >= range_.least - tolerance && value <= range_.most + tolerance;
    }

    void oneByOne()
    {
        for (std::size_t i = 0; i < count; ++i) {
            Numbers up{}, down{};
            up[i] = 1.0;
            down[i] = -1.0;
            const double above = visit(up);
            slope_[i] = above - visit(down);
            for (std::size_t s = 0; s < switches_.size(); ++s) switchSlope_[s][i] = visited_[1][s] - visited_[0][s];
        }
    }

    // All numbers at once, each in the direction that the first-order change of ρ or of a switch asks for.
    void together()
    {
        both(slope_);
        for (const Numbers& slope : switchSlope_) both(slope);
    }

    void atRandom(Random& random, int evaluations)
    {
        for (int i = 0; i < evaluations; ++i) {
            Numbers share{};
            for (double& one : share) one = random.uniform(-1.0, 1.0);
            visit(share);
        }
    }

    const Neighbourhood& range() const { return range_; }

private:
    int channel_;
    Numbers nominal_{}, step_{}, slope_{};
    Switches switches_{};
    std::array<Switches, 2> visited_{};  // of the last two visits
    std::array<Numbers, std::tuple_size_v<Switches>> switchSlope_{};
    Neighbourhood range_{};

    double visit(const Numbers& share)
    {
        Numbers numbers = nominal_;
        for (std::size_t i = 0; i < count; ++i) numbers[i] += share[i] * step_[i];
        const double rho = evaluate(numbers).rho[channel_];
        range_.least = std::min(range_.least, rho);
        range_.most = std::max(range_.most, rho);
        visited_[1] = visited_[0];
        visited_[0] = switches(numbers, channel_);
        for (std::size_t s = 0; s < switches_.size(); ++s) {
            range_.crossesJump |= (visited_[0][s] > 0.0) != (switches_[s] > 0.0);
        }
        return rho;
    }

    void both(const Numbers& slope)
    {
        Numbers up{}, down{};
        for (std::size_t i = 0; i < count; ++i) {
            up[i] = slope[i] > 0.0 ? 1.0 : -1.0;
            down[i] = -up[i];
        }
        visit(up);
        visit(down);
    }
};

}  // namespace

Reference evaluate(const model::Material& material, const GpuPoint& point)
{
    const model::Surface s{point.upperNormal, point.lowerNormal, point.thicknessUm};
    return evaluate(material, s, glm::normalize(glm::dvec3(point.light)), glm::normalize(glm::dvec3(point.view)));
}

Reference evaluate(const Input& input)
{
    return evaluate(model::derive(material(input)), point(input, 0));
}

Neighbourhood neighbourhood(const Input& input, int channel, int ulps, double accepted, double tolerance)
{
    constexpr int randomEvaluations = 200;
    Explorer explorer(input, channel, ulps);
    explorer.oneByOne();
    if (explorer.reaches(accepted, tolerance)) return explorer.range();
    explorer.together();
    if (explorer.reaches(accepted, tolerance)) return explorer.range();
    Random random(1);
    explorer.atRandom(random, randomEvaluations);
    return explorer.range();
}

Sensitivity halfUlpSensitivity(const Input& input)
{
    constexpr int combinations = 16;
    const Components floats = components(input);
    Numbers nominal{};
    std::copy(floats.begin(), floats.end(), nominal.begin());
    const Reference at = evaluate(nominal);
    Sensitivity largest{0.0, 0.0};
    const auto visit = [&](const Numbers& numbers) {
        const Reference there = evaluate(numbers);
        for (int channel = 0; channel < 3; ++channel) {
            const double scale = std::max(1.0, at.rho[channel]);
            largest.rho = std::max(largest.rho, std::fabs(there.rho[channel] - at.rho[channel]) / scale);
            largest.diffuse = std::max(largest.diffuse, std::fabs(there.diffuse[channel] - at.diffuse[channel]) / scale);
        }
    };
    for (std::size_t i = 0; i < count; ++i) {
        for (double half : {-0.5, 0.5}) {
            Numbers numbers = nominal;
            numbers[i] += half * ulp(floats[i]);
            visit(numbers);
        }
    }
    Random random(1);
    for (int combination = 0; combination < combinations; ++combination) {
        Numbers numbers = nominal;
        for (std::size_t i = 0; i < count; ++i) numbers[i] += 0.5 * random.sign() * ulp(floats[i]);
        visit(numbers);
    }
    return largest;
}

}  // namespace nacre::test
