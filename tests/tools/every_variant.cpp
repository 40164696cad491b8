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

std::string useOf(const Features& f, const std::string& output, const std::string& sampler)
{
    const bool hasTable = f.fringes == Fringes::table;
    const std::string table = hasTable ? ", fringeTable" : "";
    std::string text = output + (hasTable ? sampler : "");
    text += "void main()\n{\n    nacre_Material m = nacre_materialFromUniforms();\n    vec3 p = gl_FragCoord.xyz;\n";
    text += f.thickness == ThicknessSource::map ? "    nacre_Surface s = nacre_Surface(p, p.yzx, p.x);\n"
                                               : "    nacre_Surface s = nacre_surface(m, p, p.xyzx, p.zxy, mat3(1.0));\n";
    text += "    nacre_Shading w = nacre_shading(m, s, p.zxy" + table + ");\n    vec3 sum = vec3(0.0);\n";
    text += "    for (int i = 0; i < 2; ++i) sum += nacre_shade(m, w, p.yxz * float(i)" + table + ");\n";
    return text + "    colour = vec4(sum, 1.0);\n}\n";
}

}  // namespace nacre::test
