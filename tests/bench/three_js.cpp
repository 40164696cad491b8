#include "three_js.hpp"

#include <cmath>
#include <cstdlib>

#include "process.hpp"
#include "text_file.hpp"

namespace nacre::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* version = "0.187.0";

// The std140 layout of bench_Material in glsl/three_js.glsl.
struct Material {
    float diffuse[3] = {0.2F, 0.25F, 0.3F};
    float opacity = 1.0F;
    float specularColor[3] = {1.0F, 1.0F, 1.0F};
    float roughness = 0.3F;
    float metalness = 0.5F;
    float ior = 1.5F;
    float specularIntensity = 1.0F;
    float iridescence = 1.0F;
    float iridescenceIor = 1.3F;
    float padding[3] = {};
};

// The package's folder.
Result<fs::path> fetch(const fs::path& peers)
{
    const fs::path folder = peers / (std::string("three-") + version);
    if (fs::exists(folder / "package" / "package.json")) return folder / "package";
    std::error_code error;
    fs::create_directories(folder, error);
    const std::string package = std::string("three@") + version;
    Result<std::string> packed = run({"npm", "pack", package, "--loglevel=error", "--fetch-retries=1", "--fetch-timeout=30000", "--pack-destination", folder.string()});
    if (!packed) return packed.error();
    const std::string archive = (folder / (std::string("three-") + version + ".tgz")).string();
    Result<std::string> unpacked = run({"tar", "-xzf", archive, "-C", folder.string()});
    if (!unpacked) return unpacked.error();
    return folder / "package";
}

// What stands between the first and the last backtick of ShaderChunk/NAME.glsl.js, its includes
// resolved as WebGLProgram.js does.
Result<std::string> chunk(const fs::path& package, const std::string& name)
{
    const fs::path path = package / "src/renderers/shaders/ShaderChunk" / (name + ".glsl.js");
    Result<std::string> file = readText(path);
    if (!file) return file.error();
    const std::size_t first = file->find('`'), last = file->rfind('`');
    if (first == last) return Error{"no GLSL between backticks in " + path.string()};
    return withIncludes(file->substr(first + 1, last - first - 1), "#include <", '>',
                        [&](const std::string& included) { return chunk(package, included); });
}

// An IEEE binary16 that is neither infinite nor NaN.
float fromHalf(unsigned int bits)
{
    const int exponent = static_cast<int>(bits >> 10U & 31U);
    const auto significand = static_cast<float>(bits & 1023U);
    const float magnitude = exponent == 0 ? std::ldexp(significand, -24) : std::ldexp(significand + 1024.0F, exponent - 25);
    return bits & 0x8000U ? -magnitude : magnitude;
}

// The table of the split-sum terms that the direct light's compensation reads: 16 × 16 RG16F, linear.
Result<Table> dfgTable(const fs::path& package)
{
    const fs::path path = package / "src/renderers/shaders/DFGLUTData.js";
    Result<std::string> file = readText(path);
    if (!file) return file.error();
    Table table;
    table.sampler = "dfgLUT";
    table.width = table.height = 16;
    table.channels = 2;
    table.format = Table::Format::float16;
    for (std::size_t at = 0; (at = file->find("0x", at)) != std::string::npos; ++at) {
        table.texels.push_back(fromHalf(static_cast<unsigned int>(std::strtoul(file->c_str() + at, nullptr, 16))));
    }
    if (table.texels.size() != 512) return Error{"expected 16 x 16 x 2 numbers in " + path.string()};
    return table;
}

}  // namespace

Result<Candidate> loadThreeJs(const fs::path& peers)
{
    Result<fs::path> package = fetch(peers);
    if (!package) return Error{std::string("three.js ") + version + " cannot be fetched: " + package.error().message};

    std::string functions;
    for (const char* name : {"common", "iridescence_fragment", "lights_physical_pars_fragment"}) {
        Result<std::string> text = chunk(*package, name);
        if (!text) return text.error();
        functions += *text;
    }
    Result<std::string> material = chunk(*package, "lights_physical_fragment");
    if (!material) return material.error();
    Result<std::string> lights = chunk(*package, "lights_fragment_begin");
    if (!lights) return lights.error();
    const std::size_t loops = lights->find("IncidentLight directLight;");
    if (loops == std::string::npos) return Error{"three.js: lights_fragment_begin no longer declares directLight"};

    Result<std::string> frame = readGlsl("three_js.glsl");
    if (!frame) return frame.error();
    Result<Table> dfg = dfgTable(*package);
    if (!dfg) return dfg.error();

    Candidate candidate;
    candidate.glsl = replaced(*frame, "\nTHREE_FUNCTIONS", '\n' + functions);
    candidate.glsl = replaced(candidate.glsl, "\nTHREE_MATERIAL", '\n' + *material + lights->substr(0, loops));
    candidate.usesLibrary = false;
    candidate.blockName = "bench_Material";
    candidate.block = bytesOf(Material{});
    candidate.tables = {*dfg};
    Result<std::string> film = readGlsl("film_three_js.glsl");
    if (!film) return film.error();
    candidate.film.glsl = *film;
    return candidate;
}

}  // namespace nacre::bench
