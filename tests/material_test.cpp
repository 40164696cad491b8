// Material, validation, presets, packing: what an artist sets and what is said about it.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>

#include <nacre/nacre.hpp>

namespace {

using namespace nacre;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string onlyFault(const Material& material)
{
    const std::vector<Fault> faults = validate(material);
    EXPECT_EQ(faults.size(), 1U);
    return faults.empty() ? "" : faults.front().message;
}

TEST(Validate, NamesFieldValueAndRange)
{
    Material m;
    EXPECT_TRUE(validate(m).empty());
    m.ior.g = -1.0;
    EXPECT_EQ(onlyFault(m), "expected 0.1 <= ior.g <= 10, got -1");
    EXPECT_EQ(validate(m).front().field, "ior.g");
    EXPECT_EQ(validate(m).front().value, "-1");
    m = {};
    m.upperExponent = nan;
    EXPECT_EQ(onlyFault(m), "expected 0 <= upperExponent <= 1000000, got nan");
    m = {};
    m.thicknessMostNm = infinity;
    EXPECT_EQ(onlyFault(m), "expected 0 <= thicknessMostNm <= 1000000, got inf");
    m = {};
    m.noiseOctaves = 9;
    EXPECT_EQ(onlyFault(m), "expected 0 <= noiseOctaves <= 8, got 9");
    m = {};
    m.lowerNormal = static_cast<LowerNormal>(7);
    EXPECT_EQ(onlyFault(m), "expected 0 <= lowerNormal <= 3, got 7");
    m = {};
    m.quality = static_cast<Quality>(2);
    EXPECT_EQ(onlyFault(m), "expected 0 <= quality <= 1, got 2");
    m = {};
    m.substrate = static_cast<Substrate>(-1);
    EXPECT_EQ(onlyFault(m), "expected 0 <= substrate <= 2, got -1");
    m = {};
    m.substrateIndex.b = 0.0;
    EXPECT_EQ(onlyFault(m), "expected 0.01 <= substrateIndex.b <= 100, got 0");
    m = {};
    m.substrateAbsorption.r = -0.5;
    EXPECT_EQ(onlyFault(m), "expected 0 <= substrateAbsorption.r <= 100, got -0.5");
    m = {};
    m.substrateF0.g = 1.5;
    EXPECT_EQ(onlyFault(m), "expected 0 <= substrateF0.g <= 1, got 1.5");
    m = {};
    m.thicknessLeastNm = 500.0;
    EXPECT_EQ(onlyFault(m), "expected thicknessLeastNm <= thicknessMostNm (400), got 500");
}

TEST(Validate, NamesEveryFault)
{
    Material m;
    m.ior = {0.0, 1.5, 11.0};
    m.wavelengthNm.b = 0.0;
    m.specularWeight = -1.0;
    std::vector<std::string> fields;
    for (const Fault& fault : validate(m)) fields.push_back(fault.field);
    EXPECT_EQ(fields, (std::vector<std::string>{"ior.r", "ior.b", "wavelengthNm.b", "specularWeight"}));
}

TEST(Pack, InvalidMaterialIsAnErrorNotANan)
{
    Material m;
    m.ior.r = -1.0;
    EXPECT_EQ(pack(m).error().message, "nacre::pack(): expected 0.1 <= ior.r <= 10, got -1");
    EXPECT_EQ(evaluate(m, {}, {0, 0, 1}, {0, 0, 1}).error().message, "nacre::evaluate(): expected 0.1 <= ior.r <= 10, got -1");
    EXPECT_EQ(evaluate({}, {}, {0, 0, nan}, {0, 0, 1}).error().message, "nacre::evaluate(): expected a finite light");
    EXPECT_EQ(evaluate({}, {{0, 0, 1}, {0, 0, 1}, -1.0}, {0, 0, 1}, {0, 0, 1}).error().message,
              "nacre::evaluate(): expected a finite thicknessNm >= 0, got -1.000000");
}

// Any bit pattern in any field: a block without NaN or infinity, or an error.
TEST(Pack, HostileMaterialsNeverYieldNan)
{
    std::mt19937_64 random(1);
    const double values[] = {0.0, -0.0, 1e-320, 1e-300, 0.1, 1.0, 10.0, 1e6, 1e300, -1.0, nan, infinity, -infinity};
    std::uniform_int_distribution<std::size_t> pick(0, std::size(values) - 1);
    int packed = 0;
    for (int round = 0; round < 20000; ++round) {
        Material m;
        for (const Parameter& parameter : parameters()) {
            if (random() % 3 != 0) continue;
            const double extreme = random() % 2 ? values[pick(random)] : (random() % 2 ? parameter.least : parameter.most);
            if (const auto* real = std::get_if<double Material::*>(&parameter.member)) m.**real = extreme;
            if (const auto* rgb = std::get_if<glm::dvec3 Material::*>(&parameter.member)) (m.**rgb)[static_cast<int>(random() % 3)] = extreme;
        }
        const Result<Block> block = pack(m);
        EXPECT_EQ(static_cast<bool>(block), validate(m).empty());
        if (!block) continue;
        ++packed;
        float floats[sizeof(Block) / 4];
        std::memcpy(floats, &*block, sizeof floats);
        for (float value : floats) ASSERT_TRUE(std::isfinite(value));
    }
    EXPECT_GT(packed, 1000);
}

TEST(Pack, HeadAndTailAddUpToTheIndexOverTheWavelength)
{
    Material m;
    m.ior = {1.3330, 1.7, 2.417};
    const Block block = *pack(m);
    for (int channel = 0; channel < 3; ++channel) {
        const double head = static_cast<double>(block.cyclesPerUm[channel]), tail = static_cast<double>(block.cyclesPerUmTail[channel]);
        const double expected = m.ior[channel] / m.wavelengthNm[channel] * 1000.0;
        EXPECT_NEAR(head + tail, expected, 1e-11 * expected);  // 12 + 24 bits
        std::uint32_t bits = 0;
        std::memcpy(&bits, &block.cyclesPerUm[channel], 4);
        EXPECT_EQ(bits & 0xFFFU, 0U);
    }
}

TEST(Parameters, CoverEveryMemberOnceAndTheirDefaultsAreValid)
{
    std::set<std::string> names;
    for (const Parameter& parameter : parameters()) {
        EXPECT_TRUE(names.insert(std::string(parameter.name)).second) << parameter.name;
        EXPECT_LT(parameter.least, parameter.most) << parameter.name;
        EXPECT_FALSE(parameter.effect.empty()) << parameter.name;
        EXPECT_EQ(parameter.option.substr(0, 2), "--") << parameter.name;
    }
    EXPECT_TRUE(validate(Material{}).empty());
    // What the table has not got a place for would make the struct larger than this sum.
    EXPECT_EQ(sizeof(Material), 6 * sizeof(glm::dvec3) + 10 * sizeof(double) + 7 * sizeof(int) + 3 * sizeof(int) /* alignment */);
}

TEST(Presets, AreThePapersFiguresAndValid)
{
    for (const Preset& one : presets()) {
        EXPECT_TRUE(validate(one.material).empty()) << one.name;
        EXPECT_TRUE(preset(one.name));
    }
    const Material right = *preset("figure-3-right");
    EXPECT_EQ(right.ior, glm::dvec3(1.4, 1.45, 1.6));
    EXPECT_EQ(right.thicknessLeastNm, 66.0);
    EXPECT_EQ(right.thicknessMostNm, 76.0);
    EXPECT_EQ(right.deviationDegrees, 10.0);
    EXPECT_EQ(right.lowerNormal, LowerNormal::constant);
    EXPECT_EQ(right.upperExponent, 90.0);
    EXPECT_EQ(right.lowerExponent, 170.0);
    EXPECT_EQ(right.diffuseWeight, 0.7);
    EXPECT_EQ(preset("figure-4")->lowerNormal, LowerNormal::gradient);
    EXPECT_EQ(preset("figure-4")->diffuseWeight, 0.0);
    EXPECT_EQ(preset("figure-2-centre")->specularWeight, 0.0);
    EXPECT_EQ(preset("figure-5-left")->deviationDegrees, 14.0);
    const std::string message = preset("figure-9").error().message;
    EXPECT_EQ(message.substr(0, 66), "nacre::preset(): no preset 'figure-9', there are figure-2-left, fi");
}

}  // namespace
