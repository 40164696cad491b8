#include "every_variant.hpp"

#include <map>

namespace nacre::test {
namespace {

bool bit(unsigned bits, unsigned index)
{
    return (bits >> index & 1U) != 0;
}

}  // namespace

std::vector<Features> everyVariant()
{
    std::map<std::uint64_t, Features> variants;
    for (unsigned bits = 0; bits < 1U << 14; ++bits) {
        for (int thickness = 0; thickness < 3; ++thickness) {
            for (int lowerNormals = 0; lowerNormals < 5; ++lowerNormals) {
                Features f;
                f.paper = bit(bits, 0);
                f.physical = bit(bits, 1);
                f.specular = bit(bits, 2);
                f.diffuse = bit(bits, 3);
                if ((!f.paper && !f.physical) || (!f.specular && !f.diffuse)) continue;
                f.dispersion = bit(bits, 4);
                f.totalReflection = bit(bits, 5);
                f.substrateChannels = bit(bits, 6);
                f.metal = bit(bits, 7);
                f.normalised = bit(bits, 8);
                f.fringes = bit(bits, 9) ? Fringes::table : Fringes::samplerFree;
                f.stableLobes = bit(bits, 10);
                f.splitPhase = bit(bits, 11);
                f.polynomialCosine = bit(bits, 12);
                f.thickness = static_cast<ThicknessSource>(thickness);
                f.lowerNormals = static_cast<LowerNormals>(lowerNormals);
                f.lights = 1;
                variants.emplace(key(f), canonical(f));
            }
        }
    }
    std::vector<Features> all;
    for (const auto& [number, features] : variants) all.push_back(features);
    return all;
}

std::string nameOf(const Features& features)
{
    std::string name;
    for (const std::string& line : describe(features)) name += (name.empty() ? "" : "; ") + line;
    return name;
}

}  // namespace nacre::test
