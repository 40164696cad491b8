#pragma once

#include <random>

#include <glm/geometric.hpp>

#include "vectors.hpp"

namespace nacre::test {

/// All inputs of a case rounded to float32, so that double precision and shader see the same numbers.
inline Case rounded(Case one)
{
    const auto vector = [](glm::dvec3 a) { return glm::dvec3(glm::vec3(a)); };
    const auto real = [](double a) { return static_cast<double>(static_cast<float>(a)); };
    one.light = vector(one.light);
    one.view = vector(one.view);
    one.surface.upperNormal = vector(one.surface.upperNormal);
    one.surface.lowerNormal = vector(one.surface.lowerNormal);
    one.surface.thicknessNm = real(one.surface.thicknessNm);
    one.material.ior = vector(one.material.ior);
    one.material.iorOutside = real(one.material.iorOutside);
    one.material.wavelengthNm = vector(one.material.wavelengthNm);
    one.material.upperExponent = real(one.material.upperExponent);
    one.material.lowerExponent = real(one.material.lowerExponent);
    return one;
}

/// Cases as scenes have them: indices 1.2-1.9 with normal dispersion, up to 600 nm, exponents 5-200, tilts up to
/// 20 degrees, view near the mirror direction, in a random frame.
class TypicalCases {
public:
    explicit TypicalCases(unsigned int seed) : random_(seed) {}

    Case next()
    {
        Case one;
        const double red = uniform(1.2, 1.9), step = uniform(0.0, 0.1);
        one.material.ior = {red, red + step, red + 3.0 * step};
        one.material.upperExponent = uniform(5.0, 200.0);
        one.material.lowerExponent = uniform(5.0, 200.0);
        one.surface.thicknessNm = uniform(0.0, 600.0);
        const double theta = std::acos(uniform(0.1, 1.0)), azimuth = uniform(0.0, 6.2831853);
        const glm::dvec3 light(std::sin(theta) * std::cos(azimuth), std::sin(theta) * std::sin(azimuth), std::cos(theta));
        const glm::dvec3 mirror(-light.x, -light.y, light.z);
        const glm::dmat3 frame = rotation();
        one.light = frame * light;
        one.view = frame * glm::normalize(mirror + 0.2 * direction());
        one.surface.upperNormal = frame[2];
        one.surface.lowerNormal = frame * glm::normalize(glm::dvec3(0, 0, 1) + uniform(0.0, 0.36) * direction());
        return rounded(one);
    }

    glm::dmat3 rotation()
    {
        const glm::dvec3 z = direction(), x = glm::normalize(glm::cross(z, direction()));
        return {x, glm::cross(z, x), z};
    }

private:
    double uniform(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }

    glm::dvec3 direction()
    {
        std::normal_distribution<double> normal;
        const double x = normal(random_), y = normal(random_), z = normal(random_);
        return glm::normalize(glm::dvec3(x, y, z));
    }

    std::mt19937 random_;
};

}  // namespace nacre::test
