#include "adversarial.hpp"

#include <algorithm>
#include <cfloat>
#include <limits>

#include "geometry.hpp"

namespace nacre::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

float single(double value)
{
    return static_cast<float>(value);
}

float steps(float value, int ulps)
{
    for (; ulps > 0; --ulps) value = std::nextafter(value, infinity);
    for (; ulps < 0; ++ulps) value = std::nextafter(value, -infinity);
    return value;
}

int fewUlps(Random& random)
{
    return static_cast<int>(random.index(9)) - 4;
}

float exponent(Random& random)
{
    constexpr float ends[] = {0.0F, 1e-3F, 1.0F, 1e5F, 1e6F};
    return random.chance(0.4) ? random.pick(ends) : single(random.logUniform(1e-3, 1e6));
}

float thicknessUm(Random& random)
{
    constexpr float ends[] = {0.0F, 1e-6F, 10.0F, 1000.0F};
    if (random.chance(0.2)) return random.pick(ends);
    return single(random.chance(0.7) ? random.uniform(0.0, 1.0) : random.logUniform(1e-6, 1000.0));
}

// The cosine below which a direction outside is totally reflected; not positive where there is none.
double criticalCosine(const Input& input, int channel)
{
    const double eta = static_cast<double>(input.iorOutside) / static_cast<double>(input.ior[channel]);
    const double squared = 1.0 - 1.0 / (eta * eta);
    return squared > 0.0 ? std::sqrt(squared) : -1.0;
}

double cosTheta(Random& random, const Input& input)
{
    constexpr double nearZero[] = {1e-4, 1e-5, 1e-6, 1e-7};
    const double kind = random.uniform();
    if (kind < 0.5) return random.uniform(0.0, 1.0);
    if (kind < 0.6) return random.sign() * random.logUniform(1e-7, 1e-1);
    if (kind < 0.7) return random.sign() * random.pick(nearZero);
    if (kind < 0.75) return static_cast<double>(steps(0.0F, fewUlps(random)));
    if (kind < 0.8) return fewUlps(random) * static_cast<double>(FLT_EPSILON);
    if (kind < 0.9) {
        const double critical = criticalCosine(input, static_cast<int>(random.index(3)));
        if (critical > 0.0) return static_cast<double>(steps(single(critical), fewUlps(random)));
    }
    if (kind < 0.95) return 1.0;
    return random.uniform(-1.0, 1.0);
}

double tiltRadians(Random& random)
{
    constexpr double degrees[] = {1e-3, 60.0, 89.9, 90.0, 120.0};
    return glm::radians(random.chance(0.5) ? random.pick(degrees) : random.uniform(0.0, 30.0));
}

// The azimuth of v, from that of l, at which the lower lobe of parallel boundaries has cosine 0.
double nullAzimuth(const Input& input, double cosI, double cosO, int channel)
{
    const double eta = static_cast<double>(input.iorOutside) / static_cast<double>(input.ior[channel]);
    const auto inside = [&](double c) { return std::sqrt(std::max(0.0, 1.0 - eta * eta * (1.0 - c * c))); };
    const double sines = std::sqrt(std::max(0.0, (1.0 - cosI * cosI) * (1.0 - cosO * cosO)));
    return std::acos(std::min(1.0, inside(cosI) * inside(cosO) / std::max(1e-30, eta * eta * sines)));
}

glm::dvec3 viewDirection(Random& random, const Input& input, const Frame& frame, glm::dvec3 n1, double cosLight, double azimuth)
{
    const glm::dvec3 l(input.light), n0(frame.z);
    const double kind = random.uniform();
    if (kind < 0.15) return mirrored(l, n0);
    if (kind < 0.20) return mirrored(l, n1);
    if (kind < 0.25) return l;
    if (kind < 0.28) return n0;
    if (kind < 0.33) return glm::dvec3(-l.x, -l.y, l.z);  // the exact mirror in the standard frame
    if (kind < 0.36) return turned(random, mirrored(l, n0), 0.5 * glm::pi<double>());  // upper lobe: cosine 0
    if (kind < 0.40) {
        const double cosView = random.uniform(0.0, 1.0);
        return frame.at(cosView, azimuth + random.sign() * nullAzimuth(input, cosLight, cosView, static_cast<int>(random.index(3))));
    }
    if (kind < 0.75) {
        const double exponent = random.chance(0.5) ? static_cast<double>(input.upperExponent) : static_cast<double>(input.lowerExponent);
        const glm::dvec3 axis = random.chance(0.5) ? n0 : glm::normalize(glm::mix(n0, n1, random.uniform(0.0, 1.0)) + 1e-9 * frame.x);
        return turned(random, mirrored(l, axis), random.uniform(0.0, 3.0) / std::sqrt(std::max(4.0, exponent)));
    }
    return frame.at(cosTheta(random, input), azimuth + random.uniform(0.0, glm::two_pi<double>()));
}

glm::vec3 oddNormal(Random& random, glm::vec3 normal)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const double kind = random.uniform();
    if (kind < 0.3) return normal * 0.7F;
    if (kind < 0.4) return normal * 1e30F;
    if (kind < 0.5) return normal * 1e-30F;
    if (kind < 0.6) return normal * 1e-41F;
    if (kind < 0.7) return glm::vec3(0.0F);
    glm::vec3 odd = random.chance(0.5) ? normal : glm::vec3(0.0F);
    odd[static_cast<int>(random.index(3))] = kind < 0.8 ? nan : kind < 0.9 ? infinity : -infinity;
    return odd;
}

}  // namespace

void setMaterial(Random& random, Input& input)
{
    constexpr float outside[] = {1.0F, 1.0F, 1.33F, 1.5F};
    input.iorOutside = random.chance(0.05) ? single(random.logUniform(0.1, 10.0)) : random.pick(outside);
    const double kind = random.uniform();
    const double ior = random.uniform(1.0, 2.5);
    for (int channel = 0; channel < 3; ++channel) {
        if (kind < 0.5) input.ior[channel] = single(ior + 0.02 * channel);
        else if (kind < 0.6) input.ior[channel] = single(random.uniform(1.0, 2.5));
        else if (kind < 0.7) input.ior[channel] = single(static_cast<double>(input.iorOutside) + random.sign() * 1e-7);
        else if (kind < 0.75) input.ior[channel] = steps(input.iorOutside, fewUlps(random));
        else if (kind < 0.85) input.ior[channel] = single(static_cast<double>(input.iorOutside) + random.sign() * random.logUniform(1e-7, 1e-2));
        else if (kind < 0.95) input.ior[channel] = single(random.uniform(0.6, 1.0) * static_cast<double>(input.iorOutside));
        else input.ior[channel] = single(random.logUniform(0.1, 10.0));
        input.ior[channel] = std::clamp(input.ior[channel], 0.1F, 10.0F);
    }
    input.upperExponent = exponent(random);
    input.lowerExponent = random.chance(0.3) ? input.upperExponent : exponent(random);
    input.wavelengthNm = random.chance(0.5) ? glm::vec3(645.0F, 525.0F, 445.0F) : glm::vec3(780.0F, 550.0F, 380.0F);
}

void setPoint(Random& random, Input& input)
{
    input.thicknessUm = thicknessUm(random);
    const Frame frame = randomFrame(random);
    const double cosLight = cosTheta(random, input);
    const double azimuth = random.chance(0.1) ? 0.0 : random.uniform(0.0, glm::two_pi<double>());
    const bool isParallel = random.chance(0.5);
    const glm::dvec3 n1 = isParallel ? frame.z : turned(random, frame.z, tiltRadians(random));
    input.light = rounded(frame.at(cosLight, azimuth));
    input.view = rounded(viewDirection(random, input, frame, n1, cosLight, azimuth));
    input.upperNormal = rounded(frame.z);
    input.lowerNormal = isParallel ? input.upperNormal : rounded(n1);
    if (random.chance(0.02)) input.upperNormal = oddNormal(random, input.upperNormal);
    if (random.chance(0.02)) input.lowerNormal = oddNormal(random, input.lowerNormal);
}

bool lacksDirection(glm::vec3 normal)
{
    const bool isFinite = std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z);
    return !isFinite || normal == glm::vec3(0.0F);
}

bool isDenormal(glm::vec3 normal)
{
    const float largest = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
    return largest < FLT_MIN && largest > 0.0F;
}

}  // namespace nacre::test
