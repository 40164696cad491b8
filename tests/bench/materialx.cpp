#include "materialx.hpp"

#include <set>

#include "process.hpp"
#include "text_file.hpp"

namespace nacre::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* version = "1.39.5";

// The std140 layout of bench_Material in glsl/materialx.glsl.
struct Material {
    float tint[3] = {1.0F, 1.0F, 1.0F};
    float weight = 1.0F;
    float roughness[2] = {0.09F, 0.09F};
    float ior = 1.5F;
    float thinFilmIor = 1.3F;
    float metalIor[3] = {0.155F, 0.425F, 1.345F};  // gold
    float metalness = 0.5F;
    float metalExtinction[3] = {3.484F, 2.453F, 1.773F};
    float diffuseRoughness = 0.0F;
    float baseColor[3] = {0.2F, 0.25F, 0.3F};
    float padding = 0.0F;
};

// The package's folder of libraries.
Result<fs::path> fetch(const fs::path& peers)
{
    const fs::path folder = peers / (std::string("materialx-") + version);
    const fs::path libraries = folder / "MaterialX" / "libraries";
    if (fs::exists(libraries / "pbrlib")) return libraries;
    const std::string package = std::string("MaterialX==") + version;
    Result<std::string> installed =
        run({"python3", "-m", "pip", "install", "--quiet", "--no-deps", "--no-compile", "--retries", "1", "--timeout", "30", "--target", folder.string(), package});
    if (!installed) return installed.error();
    return libraries;
}

// A file with the files that it includes before it, each once.
Result<std::string> resolve(const fs::path& path, std::set<fs::path>& seen)
{
    if (!seen.insert(path).second) return std::string();
    Result<std::string> file = readText(path);
    if (!file) return file.error();
    Result<std::string> text = withIncludes(*file, "#include \"", '"', [&](const std::string& included) {
        return resolve((path.parent_path() / included).lexically_normal(), seen);
    });
    return text ? *text + '\n' : text;
}

Result<Candidate> load(const fs::path& peers, bool isStandardSurface)
{
    Result<fs::path> libraries = fetch(peers);
    if (!libraries) return Error{std::string("MaterialX ") + version + " cannot be fetched: " + libraries.error().message};

    std::set<fs::path> seen;
    std::string functions;
    for (const char* file : {"stdlib/genglsl/lib/mx_math.glsl", "pbrlib/genglsl/lib/mx_environment_none.glsl",
                             "pbrlib/genglsl/lib/mx_transmission_opacity.glsl", "pbrlib/genglsl/mx_dielectric_bsdf.glsl",
                             "pbrlib/genglsl/mx_conductor_bsdf.glsl", "pbrlib/genglsl/mx_oren_nayar_diffuse_bsdf.glsl",
                             "pbrlib/genglsl/mx_layer_bsdf.glsl", "pbrlib/genglsl/mx_mix_bsdf.glsl"}) {
        Result<std::string> text = resolve(*libraries / file, seen);
        if (!text) return text.error();
        functions += *text;
    }
    // The tokens that the shader generator would replace.
    functions = replaced(functions, "$closureDataConstructor", "ClosureData(closureType, L, V, N, P, occlusion)");
    functions = replaced(functions, "$texSamplerSignature", "sampler2D tex_sampler");
    functions = replaced(functions, "$texSamplerSampler2D", "tex_sampler");

    Result<std::string> frame = readGlsl("materialx.glsl");
    if (!frame) return frame.error();
    Candidate candidate;
    candidate.glsl = "#define BENCH_STANDARD_SURFACE " + std::to_string(isStandardSurface ? 1 : 0) + '\n';
    candidate.glsl += replaced(*frame, "\nMATERIALX_FUNCTIONS", '\n' + functions);
    candidate.usesLibrary = false;
    candidate.blockName = "bench_Material";
    candidate.block = bytesOf(Material{});
    Result<std::string> film = readGlsl("film_materialx.glsl");
    if (!film) return film.error();
    candidate.film.glsl = *film;
    candidate.film.hasMetals = isStandardSurface;
    return candidate;
}

}  // namespace

Result<Candidate> loadMaterialXDielectric(const fs::path& peers) { return load(peers, false); }
Result<Candidate> loadMaterialXSurface(const fs::path& peers) { return load(peers, true); }

}  // namespace nacre::bench
