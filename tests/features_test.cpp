// A material's own shader against the shader of everything: the same picture within the error that was accepted.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include <glm/geometric.hpp>

#include <nacre/features.hpp>
#include <nacre/glsl.hpp>
#include <nacre/presets.hpp>

#include "every_variant.hpp"
#include "form_errors.hpp"
#include "gl/fringe_texture.hpp"
#include "gpu.hpp"
#include "point_program.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

constexpr int fringeUnit = 2;

// The whole of a shader. With a map the point states thickness and lower normal, else the material makes them.
const char* const shadePoint = R"(
#if USE_TABLE
uniform sampler2D fringeTable;
#define FRINGES , fringeTable
#else
#define FRINGES
#endif
layout(location = 0) out vec4 colour;

void main()
{
    nacre_Material m = pointMaterial();
    nacre_Surface s = pointSurface();
#if USE_MAP == 0
    s = nacre_surface(m, s.upperNormal, vec4(s.lowerNormal, 1.0), 2.0 * s.lowerNormal + s.thicknessUm, mat3(1.0));
#elif USE_LOWER_NORMAL == 0
    s.lowerNormal = s.upperNormal;
#endif
    nacre_Shading w = nacre_shading(m, s, pointView() FRINGES);
    colour = vec4(nacre_shade(m, w, pointLight() FRINGES), 1.0);
}
)";

struct Shader {
    bool hasTable, hasMap, hasLowerNormal;

    PointProgram make(const Features& features) const
    {
        const auto define = [](const char* name, bool value) { return std::string("#define ") + name + (value ? " 1\n" : " 0\n"); };
        const std::string main = define("USE_TABLE", hasTable) + define("USE_MAP", hasMap) + define("USE_LOWER_NORMAL", hasLowerNormal) + shadePoint;
        Result<PointProgram> program = PointProgram::create(context(), main, 1, {"", features, true});
        if (!program) throw std::runtime_error(nameOf(features) + ": " + program.error().message);
        if (hasTable) program->bindTexture("fringeTable", fringeUnit, fringeTexture());
        return *program;
    }

    static const FringeTable& fringeTable()
    {
        static const Result<FringeTable> table = FringeTable::create();
        return *table;
    }
    static GLuint fringeTexture()
    {
        static const GLuint texture = [] {
            context().gl().ActiveTexture(GL_TEXTURE0 + fringeUnit);
            return demo::makeFringeTexture(context().gl(), fringeTable());
        }();
        return texture;
    }
};

double uniform(std::mt19937_64& random, double least, double most)
{
    return least + (most - least) * static_cast<double>(random() >> 11U) * 0x1p-53;
}

double either(std::mt19937_64& random, std::initializer_list<double> special, double least, double most)
{
    return random() % 2 ? uniform(random, least, most) : special.begin()[random() % special.size()];
}

// Materials as scenes have them, with every way in which a part may do nothing. isTypical: the region whose error is stated
// as 3e-6; else thick layers, high exponents and indices below the outside's too.
Material randomMaterial(std::mt19937_64& random, bool isTypical)
{
    Material m;
    m.quality = static_cast<Quality>(random() % 2);
    m.iorOutside = isTypical ? 1.0 : either(random, {1.0, 1.0, 1.33}, 1.0, 1.5);
    m.ior = glm::dvec3(isTypical ? uniform(random, 1.2, 1.9) : uniform(random, 1.0, 2.5));
    if (random() % 2) m.ior += glm::dvec3(0.0, uniform(random, 0.0, 0.05), uniform(random, 0.0, 0.1));
    m.thicknessLeastNm = either(random, {0.0, 300.0}, 0.0, 300.0);
    m.thicknessMostNm = m.thicknessLeastNm + either(random, {0.0}, 0.0, isTypical ? 300.0 : 20000.0);
    m.noiseFrequency = either(random, {0.0, 1.5}, 0.1, 3.0);
    m.noiseOctaves = static_cast<int>(random() % 4);
    m.lowerNormal = static_cast<LowerNormal>(random() % 4);
    m.deviationDegrees = either(random, {0.0, 10.0}, 0.0, isTypical ? 20.0 : 120.0);
    m.azimuthDegrees = either(random, {0.0}, -180.0, 180.0);
    m.upperExponent = isTypical ? uniform(random, 5.0, 200.0) : either(random, {0.0, 1.0, 1e4}, 0.5, 3000.0);
    m.lowerExponent = isTypical ? uniform(random, 5.0, 200.0) : either(random, {0.0, 1.0, 1e4}, 0.5, 3000.0);
    m.specularWeight = either(random, {0.0, 1.0, 1.0}, 0.0, 1.0);
    m.diffuseWeight = either(random, {0.0, 0.0, 0.5}, 0.0, 1.0);
    m.substrate = static_cast<Substrate>(random() % 3);
    m.substrateIndex = glm::dvec3(uniform(random, 0.2, 3.0));
    if (random() % 2) m.substrateIndex.g = uniform(random, 0.2, 3.0);
    m.substrateAbsorption = glm::dvec3(either(random, {0.0}, 0.5, 6.0));
    m.substrateF0 = random() % 2 ? glm::dvec3(0.04) : glm::dvec3(0.9, 0.6, 0.3);
    m.lobes = static_cast<Lobes>(random() % 2);
    m.diffuseAlbedo = random() % 4 ? glm::dvec3(0.8, 0.5, 0.2) : glm::dvec3(0.0);
    return m;
}

glm::vec3 direction(std::mt19937_64& random, double leastCosine)
{
    const double z = uniform(random, leastCosine, 1.0), azimuth = uniform(random, 0.0, 6.2831853), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

// Around the z axis; views near the mirror direction and anywhere, a few from below.
std::vector<GpuPoint> randomPoints(std::mt19937_64& random, const Material& m, bool isTypical, std::size_t count)
{
    std::vector<GpuPoint> points(count);
    for (GpuPoint& p : points) {
        const double least = isTypical ? 0.2 : 0.02;
        p.light = direction(random, least);
        p.view = glm::normalize(glm::vec3(-p.light.x, -p.light.y, p.light.z) + static_cast<float>(uniform(random, 0.0, 0.4)) * direction(random, -1.0));
        if (random() % 4 == 0) p.view = direction(random, isTypical ? least : -0.2);
        if (isTypical && static_cast<double>(p.view.z) < least) p.view = glm::vec3(-p.light.x, -p.light.y, p.light.z);
        p.upperNormal = {0.0F, 0.0F, 1.0F};
        p.lowerNormal = direction(random, 0.9);
        p.thicknessUm = static_cast<float>(uniform(random, m.thicknessLeastNm, m.thicknessMostNm) / 1000.0);
    }
    return points;
}

std::vector<glm::vec4> draw(const PointProgram& program, const Block& block, const std::vector<GpuPoint>& points)
{
    std::vector<glm::vec4> pixels(points.size());
    program.setBlock(block);
    program.draw(points.data(), points.size());
    program.read(0, pixels.data(), pixels.size());
    return pixels;
}

// The worst difference over max(1, the pixel).
double difference(const std::vector<glm::vec4>& got, const std::vector<glm::vec4>& expected)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < got.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const double wanted = static_cast<double>(expected[i][channel]);
            const double error = std::fabs(static_cast<double>(got[i][channel]) - wanted) / std::max(1.0, wanted);
            if (!(error <= worst)) worst = error;
        }
    }
    return worst;
}

struct Check {
    double error;
    bool isTypical;
    int materials;
};

// Material by material: its own shader, for the error, against the shader of everything.
double compareOwnShaders(const Check& check, double allowed)
{
    std::mt19937_64 random(11);
    std::map<int, PointProgram> whole;
    double most = 0.0;
    for (int i = 0; i < check.materials; ++i) {
        const Material m = randomMaterial(random, check.isTypical);
        FeatureOptions options;
        options.error = check.error;
        options.thicknessMap = random() % 3 == 0;
        options.lowerNormalMap = options.thicknessMap && random() % 2;
        options.fringes = random() % 2 ? Fringes::table : Fringes::samplerFree;
        const Features features = *featuresOf(m, options);
        const bool isPhysical = m.quality == Quality::physical;
        const Shader all{isPhysical && options.fringes == Fringes::table, options.thicknessMap, options.lowerNormalMap};
        const Shader own{canonical(features).fringes == Fringes::table, options.thicknessMap, options.lowerNormalMap};
        const int number = all.hasTable + 2 * all.hasMap + 4 * all.hasLowerNormal;
        auto found = whole.find(number);
        if (found == whole.end()) found = whole.emplace(number, all.make(Features{})).first;

        const Block block = *pack(m, all.hasTable ? &Shader::fringeTable() : nullptr);
        const std::vector<GpuPoint> points = randomPoints(random, m, check.isTypical, 2048);
        const PointProgram program = own.make(features);
        const std::vector<glm::vec4> got = draw(program, block, points), expected = draw(found->second, block, points);
        program.destroy();
        const double worst = difference(got, expected);
        EXPECT_LE(worst, allowed) << i << ": " << nameOf(features) << "; exponents " << m.upperExponent << ", " << m.lowerExponent << "; up to "
                                  << m.thicknessMostNm << " nm, deviation " << m.deviationDegrees << ", ior " << m.ior.r << " under " << m.iorOutside
                                  << ", lower normal " << static_cast<int>(m.lowerNormal);
        most = std::max(most, worst);
    }
    return most;
}

// No error accepted: what is left is the order of operations in float32. 3e-6 is what the typical region is stated for.
TEST(Features, OfNoErrorChangeNothing)
{
    const double most = compareOwnShaders({0.0, true, NACRE_SANITIZED ? 15 : 60}, 3e-6);
    std::printf("typical materials, no error accepted: %.2g\n", most);
    EXPECT_GT(most, 0.0);
}

// The default: a quarter of a step of eight bits, over all of the materials.
TEST(Features, KeepTheErrorThatIsAccepted)
{
    const double most = compareOwnShaders({FeatureOptions{}.error, false, NACRE_SANITIZED ? 15 : 80}, FeatureOptions{}.error);
    std::printf("all materials, a quarter of a step of eight bits: %.2g\n", most);
}

// A set's shader serves each of its materials as that material's own does.
TEST(Features, JoinedServeBothMaterials)
{
    std::mt19937_64 random(12);
    const Shader whole{false, false, false};
    const PointProgram all = whole.make(Features{});
    double most = 0.0;
    for (int i = 0; i < (NACRE_SANITIZED ? 6 : 20); ++i) {
        FeatureOptions options;
        options.fringes = Fringes::samplerFree;
        const Material materials[] = {randomMaterial(random, true), randomMaterial(random, true)};
        const Features joined = join(*featuresOf(materials[0], options), *featuresOf(materials[1], options));
        EXPECT_EQ(joined, join(joined, *featuresOf(materials[0], options)));
        const PointProgram program = whole.make(joined);
        for (const Material& m : materials) {
            const std::vector<GpuPoint> points = randomPoints(random, m, true, 1024);
            const double worst = difference(draw(program, *pack(m), points), draw(all, *pack(m), points));
            EXPECT_LE(worst, options.error) << i << ": " << nameOf(joined) << "; of " << nameOf(*featuresOf(m, options)) << "; lower normal "
                                            << static_cast<int>(m.lowerNormal) << ", deviation " << m.deviationDegrees << ", octaves " << m.noiseOctaves
                                            << ", frequency " << m.noiseFrequency << ", " << m.thicknessLeastNm << ".." << m.thicknessMostNm << " nm, exponents "
                                            << m.upperExponent << ", " << m.lowerExponent << ", weights " << m.specularWeight << ", " << m.diffuseWeight;
            most = std::max(most, worst);
        }
        program.destroy();
    }
    std::printf("pairs of materials: %.2g\n", most);
}

// What featuresOf goes by is what the forms err here.
TEST(Features, CheapFormsKeepTheirBounds)
{
    const Result<std::vector<FormError>> errors = measureForms(context(), NACRE_SANITIZED ? 300 : 3000, 5);
    ASSERT_TRUE(errors) << errors.error().message;
    EXPECT_GE(errors->size(), 14U);
    for (const FormError& error : *errors) {
        EXPECT_LE(error.worst, error.stated) << error.form << " up to " << error.upTo;
        EXPECT_GE(error.worst, error.stated / 40.0) << error.form << " up to " << error.upTo << ": the bound is far too wide";
    }
}

TEST(Features, KeysTellVariantsApart)
{
    std::map<std::uint64_t, std::string> texts;
    for (const Features& features : everyVariant()) {
        EXPECT_EQ(canonical(features), features);
        EXPECT_TRUE(texts.emplace(key(features), switches(features)).second) << nameOf(features);
    }
    std::map<std::string, std::uint64_t> keys;
    for (const auto& [number, text] : texts) EXPECT_TRUE(keys.emplace(text, number).second) << text;
}

TEST(Features, FaultsAreErrors)
{
    Material m;
    m.ior.g = -1.0;
    EXPECT_EQ(featuresOf(m).error().message, "nacre::featuresOf(): expected 0.1 <= ior.g <= 10, got -1");
    FeatureOptions options;
    options.error = std::nan("");
    EXPECT_EQ(featuresOf(Material{}, options).error().message, "nacre::featuresOf(): expected error >= 0, got nan");
    options = {};
    options.lights = 0;
    EXPECT_EQ(featuresOf(Material{}, options).error().message, "nacre::featuresOf(): expected lights >= 1, got 0");
}

// What a plain material needs, spelt out once.
TEST(Features, OfAPlainMaterialAreFew)
{
    Material m;
    m.ior = glm::dvec3(1.5);
    m.noiseOctaves = 0;
    const Features f = *featuresOf(m);
    Features expected;
    expected.physical = expected.dispersion = expected.totalReflection = expected.substrateChannels = expected.metal = expected.normalised = false;
    expected.stableLobes = expected.splitPhase = expected.polynomialCosine = false;
    expected.thickness = ThicknessSource::constant;
    expected.lowerNormals = LowerNormals::parallel;
    expected.fringes = Fringes::samplerFree;
    EXPECT_EQ(f, expected) << nameOf(f);
    EXPECT_EQ(describe(f), (std::vector<std::string>{"quality paper: two beams, three wavelengths", "specular part: two lobes",
                                                     "diffuse part: one colour, from the host", "constant thickness", "parallel boundaries"}));
}

}  // namespace
