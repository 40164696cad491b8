#include "regions.hpp"

#include <algorithm>

#include "geometry.hpp"

namespace nacre::test {
namespace {

float single(double value)
{
    return static_cast<float>(value);
}

// The typical region's material: a film of glass or plastic with some dispersion.
Input typicalMaterial(Random& random)
{
    Input input{};
    const double ior = random.uniform(1.3, 1.8);
    const double dispersion = random.uniform(0.0, 0.05);
    input.ior = glm::vec3(glm::dvec3(ior, ior + dispersion, ior + 2.5 * dispersion));
    input.iorOutside = 1.0F;
    input.wavelengthNm = {645.0F, 525.0F, 445.0F};
    input.thicknessUm = single(random.uniform(0.0, 0.6));
    input.upperExponent = single(random.uniform(10.0, 200.0));
    input.lowerExponent = single(random.uniform(10.0, 200.0));
    return input;
}

// Light at a given cosine, the lower normal at a given tilt, and a viewer where the lobes are: around the
// mirror directions of normals from the upper one to beyond the lower one, as wide as the wider lobe. One in five
// views is anywhere. What it makes is redrawn until both directions are above the surface.
void aim(Random& random, Input& input, double cosLight, double tilt)
{
    const Frame frame = randomFrame(random);
    const glm::dvec3 l = frame.at(cosLight, random.uniform(0.0, glm::two_pi<double>()));
    const glm::dvec3 n1 = tilt == 0.0 ? frame.z : turned(random, frame.z, tilt);
    const double width = 2.0 / std::sqrt(std::max(1.0, static_cast<double>(std::min(input.upperExponent, input.lowerExponent))));
    glm::dvec3 v;
    do {
        if (random.chance(0.2)) {
            v = frame.at(random.uniform(0.01, 1.0), random.uniform(0.0, glm::two_pi<double>()));
        } else {
            const glm::dvec3 between = glm::normalize(glm::mix(frame.z, n1, tilt == 0.0 ? 0.0 : random.uniform(0.0, 1.6)) + 1e-9 * frame.x);
            v = turned(random, mirrored(l, between), random.uniform(0.0, width));
        }
        if (dot(v, frame.z) < 0.25 * cosLight) v = mirrored(l, frame.z);
    } while (dot(v, frame.z) <= 0.0);
    input.light = rounded(l);
    input.view = rounded(v);
    input.upperNormal = rounded(frame.z);
    input.lowerNormal = tilt == 0.0 ? input.upperNormal : rounded(n1);
}

double smallTilt(Random& random)
{
    return random.chance(0.5) ? 0.0 : random.uniform(0.0, glm::radians(15.0));
}

Input typical(Random& random)
{
    Input input = typicalMaterial(random);
    aim(random, input, random.uniform(0.2, 1.0), smallTilt(random));
    return input;
}

Input grazing(Random& random)
{
    Input input = typicalMaterial(random);
    aim(random, input, random.logUniform(1e-5, 0.1), smallTilt(random));
    return input;
}

Input largeExponent(Random& random)
{
    Input input = typicalMaterial(random);
    input.upperExponent = single(random.logUniform(1e3, 1e6));
    input.lowerExponent = single(random.logUniform(1e3, 1e6));
    aim(random, input, random.uniform(0.2, 1.0), random.chance(0.7) ? 0.0 : random.logUniform(1e-4, 0.1));
    return input;
}

Input smallExponent(Random& random)
{
    Input input = typicalMaterial(random);
    input.upperExponent = random.chance(0.2) ? 0.0F : single(random.logUniform(1e-3, 10.0));
    input.lowerExponent = random.chance(0.2) ? 0.0F : single(random.logUniform(1e-3, 10.0));
    aim(random, input, random.uniform(0.2, 1.0), smallTilt(random));
    return input;
}

Input thick(Random& random)
{
    Input input = typicalMaterial(random);
    input.thicknessUm = single(random.logUniform(1.0, 1000.0));
    aim(random, input, random.uniform(0.2, 1.0), smallTilt(random));
    return input;
}

Input tilted(Random& random)
{
    Input input = typicalMaterial(random);
    aim(random, input, random.uniform(0.2, 1.0), glm::radians(random.uniform(15.0, 120.0)));
    return input;
}

Input matchedIndex(Random& random)
{
    Input input = typicalMaterial(random);
    input.iorOutside = single(random.uniform(1.0, 1.5));
    for (int channel = 0; channel < 3; ++channel) {
        input.ior[channel] = single(static_cast<double>(input.iorOutside) + random.logUniform(1e-7, 1e-2));
    }
    aim(random, input, random.uniform(0.2, 1.0), smallTilt(random));
    return input;
}

Input belowOutside(Random& random)
{
    Input input = typicalMaterial(random);
    input.iorOutside = single(random.uniform(1.3, 1.8));
    for (int channel = 0; channel < 3; ++channel) {
        input.ior[channel] = single(random.uniform(1.0, static_cast<double>(input.iorOutside)));
    }
    aim(random, input, random.uniform(0.2, 1.0), smallTilt(random));
    return input;
}

}  // namespace

Region formRegion(double leastExponent, double mostExponent, double leastCycles, double mostCycles)
{
    const auto make = [=](Random& random) {
        Input input = typicalMaterial(random);
        const double ior = random.chance(0.2) ? 1.0 : random.uniform(1.0, 2.8), dispersion = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.08);
        input.ior = glm::vec3(glm::dvec3(ior, ior + dispersion, ior + 2.5 * dispersion));
        input.upperExponent = single(random.logUniform(leastExponent, mostExponent));
        input.lowerExponent = single(random.logUniform(leastExponent, mostExponent));
        const double cycles = random.uniform(leastCycles, mostCycles);
        input.thicknessUm = single(0.5 * cycles * static_cast<double>(input.wavelengthNm.b) / 1000.0 / static_cast<double>(input.ior.b));
        aim(random, input, random.chance(0.3) ? random.logUniform(1e-3, 0.2) : random.uniform(0.2, 1.0),
            random.chance(0.5) ? 0.0 : random.uniform(0.0, glm::radians(60.0)));
        return input;
    };
    return {"form", "of one range", make};
}

const std::vector<Region>& regions()
{
    static const std::vector<Region> all = {
        {"typical", "index 1.3-1.9, up to 600 nm, exponents 10-200, cosines from 0.2, tilt up to 15°", typical},
        {"grazing", "cosine of the light 1e-5-0.1", grazing},
        {"large exponent", "1e3-1e6", largeExponent},
        {"small exponent", "0-10", smallExponent},
        {"thick", "1 µm-1 mm", thick},
        {"tilted", "lower normal at 15°-120°", tilted},
        {"matched index", "1e-7-1e-2 above the outside", matchedIndex},
        {"below outside", "index 1-1.8 under an outside of 1.3-1.8: total reflection", belowOutside},
    };
    return all;
}

}  // namespace nacre::test
