#include "inputs.hpp"

#include <cstdio>
#include <cstring>

#include <glm/geometric.hpp>

namespace nacre::test {

Components components(const Input& input)
{
    Components numbers{};
    std::memcpy(numbers.data(), &input, sizeof input);
    return numbers;
}

Input input(const Components& components)
{
    Input whole{};
    std::memcpy(&whole, components.data(), sizeof whole);
    return whole;
}

nacre::Material material(const Input& input)
{
    nacre::Material material;
    material.ior = input.ior;
    material.iorOutside = input.iorOutside;
    material.wavelengthNm = input.wavelengthNm;
    material.upperExponent = input.upperExponent;
    material.lowerExponent = input.lowerExponent;
    material.diffuseWeight = 1.0;  // the coefficient itself
    return material;
}

GpuPoint point(const Input& input, std::size_t material)
{
    return {input.light, input.thicknessUm, input.view, static_cast<float>(material), input.upperNormal, 0.0F, input.lowerNormal, 0.0F};
}

std::string csvLine(const Input& input)
{
    const Components numbers = components(input);
    std::string line;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        char cell[40];
        const double number = numbers[i];
        if (i == thicknessComponent) std::snprintf(cell, sizeof cell, "%.17g", number * 1000.0);
        else std::snprintf(cell, sizeof cell, "%.9g", number);
        line += i == 0 ? "" : ",";
        line += cell;
    }
    return line;
}

glm::vec3 rounded(glm::dvec3 direction)
{
    glm::vec3 result = glm::normalize(direction);
    for (int attempt = 0; attempt < 4; ++attempt) {  // one in a few thousand needs more, and stays an ulp off
        const glm::vec3 again = glm::normalize(glm::dvec3(result));
        if (again == result) break;
        result = again;
    }
    return result;
}

}  // namespace nacre::test
