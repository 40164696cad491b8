// The one list of all candidates. To add one of the library's, add a line to candidateEntries() below with a material
// and what is known of the shader beside it. Any other:
//   1. put its GLSL into glsl/NAME.glsl: struct bench_View, bench_view(), bench_light(); see candidate.hpp;
//   2. fill Candidate: a block of its own (blockName, block), tables (sampler, size, filter, texels);
//   3. if it models a film, it has a FilmHook with bench_film(), glsl/film.glsl, or its errors are left out.
// Each of the library's stable forms made naive by itself is a candidate too, full-naive-NAME, from
// naiveForms(). --candidates and the report take up the names by themselves.

#include "candidates.hpp"

#include <nacre/block.hpp>
#include <nacre/fringe_table.hpp>

#include "materialx.hpp"
#include "naive_forms.hpp"
#include "text_file.hpp"
#include "three_js.hpp"

namespace nacre::bench {
namespace {

namespace fs = std::filesystem;

// A candidate whose only input is nacre's own block.
Result<Candidate> library(const char* file, const Material& material)
{
    Result<std::string> text = readGlsl(file);
    if (!text) return text.error();
    Result<Block> block = pack(material);
    if (!block) return block.error();
    Candidate candidate;
    candidate.glsl = *text;
    candidate.blockName = "nacre_Block";
    candidate.block = bytesOf(*block);
    return candidate;
}

// The same for one that is a layer, not only lit from nacre's block: its film's errors can be measured.
Result<Candidate> layer(const char* file, const Material& material)
{
    Result<Candidate> candidate = library(file, material);
    if (!candidate) return candidate;
    Result<std::string> hook = readGlsl("film_library.glsl");
    if (!hook) return hook.error();
    candidate->film.glsl = *hook;
    candidate->film.hasSubstrate = material.quality == Quality::physical;
    candidate->film.block = [quality = material.quality](const test::FilmCase& film) -> Result<std::vector<unsigned char>> {
        Result<Block> block = pack(test::materialOf(film, quality));
        if (!block) return block.error();
        return bytesOf(*block);
    };
    return candidate;
}

// Figure 3's material: an index per channel, both parts.
Material dispersive()
{
    Material material;
    material.ior = {1.4, 1.45, 1.6};
    material.diffuseWeight = 0.7;
    return material;
}

Material oneIndex()
{
    Material material;
    material.ior = {1.45, 1.45, 1.45};
    material.substrateIndex = {1.77, 1.77, 1.77};
    material.diffuseWeight = 0.0;
    return material;
}

Result<Candidate> flat(const fs::path&)
{
    Result<std::string> text = readGlsl("flat.glsl");
    if (!text) return text.error();
    Candidate candidate;
    candidate.glsl = *text;
    candidate.usesLibrary = false;
    return candidate;
}

// The table as a host would bind it.
Result<Table> fringeTable()
{
    Result<FringeTable> fringes = FringeTable::create();
    if (!fringes) return fringes.error();
    Table table;
    table.sampler = "bench_fringeTable";
    table.width = FringeTable::width;
    table.height = FringeTable::height;
    table.format = Table::Format::float16;
    table.texels.assign(fringes->texels().begin(), fringes->texels().end());
    return table;
}

// A shader of the library's as its user would have it.
struct Variant {
    Material material;
    FeatureOptions options;
    std::function<void(Features&)> change;  ///< What the material does not ask for.
    bool isDetail = false;
};

Result<Candidate> variant(const Variant& v)
{
    Result<Candidate> candidate = layer("variant.glsl", v.material);
    if (!candidate) return candidate;
    Result<Features> features = featuresOf(v.material, v.options);
    if (!features) return features.error();
    if (v.change) v.change(*features);
    candidate->features = canonical(*features);
    candidate->isDetail = v.isDetail;
    candidate->film.hasMetals = v.material.quality == Quality::paper || candidate->features.metal;
    // A detail is timed alone; those of constant thickness or the library's own would not ask for a film's anyway.
    if (v.isDetail) candidate->film = {};
    if (candidate->features.fringes == Fringes::table) {
        Result<Table> table = fringeTable();
        if (!table) return table.error();
        candidate->tables.push_back(*table);
    }
    return candidate;
}

std::function<Result<Candidate>(const fs::path&)> of(const Variant& v)
{
    return [v](const fs::path&) { return variant(v); };
}

FeatureOptions maps(bool tilt, double error = FeatureOptions{}.error)
{
    FeatureOptions options;
    options.error = error;
    options.thicknessMap = true;
    options.lowerNormalMap = tilt;
    options.fringes = Fringes::samplerFree;
    return options;
}

Material physical(Material material)
{
    material.quality = Quality::physical;
    return material;
}

Material overGold(Material material)
{
    material.substrate = Substrate::metal;
    material.substrateIndex = {0.155, 0.425, 1.345};
    material.substrateAbsorption = {3.484, 2.453, 1.773};
    return material;
}

Variant paper(const Material& material, bool tilt, double error = FeatureOptions{}.error)
{
    return {material, maps(tilt, error), {}};
}

Variant film(const Material& material, bool tilt, Fringes fringes)
{
    Variant v{physical(material), maps(tilt), {}};
    v.options.fringes = fringes;
    return v;
}

Variant diffuseAlone()
{
    Material material = oneIndex();
    material.specularWeight = 0.0;
    material.diffuseWeight = 0.7;
    material.noiseOctaves = 0;
    Variant v{material, {}, {}};
    v.isDetail = true;
    return v;
}

// Everything in its most accurate form, for the naive forms to be compared with.
Result<Candidate> paperFullExact(const fs::path&)
{
    return variant(paper(dispersive(), true, 0.0));
}

Result<Candidate> phongLambert(const fs::path&) { return library("phong_lambert.glsl", dispersive()); }
Result<Candidate> paperFullNaive(const fs::path&) { return layer("paper_full_naive.glsl", dispersive()); }
Result<Candidate> paperParallelNaive(const fs::path&) { return layer("paper_parallel_naive.glsl", oneIndex()); }

Result<Candidate> lambert(const fs::path&)
{
    Result<Candidate> candidate = library("lambert.glsl", diffuseAlone().material);
    if (candidate) candidate->isDetail = true;
    return candidate;
}

std::vector<CandidateEntry> withNaiveForms(std::vector<CandidateEntry> entries)
{
    for (const test::NaiveForm& form : test::naiveForms()) {
        const std::string name = form.name;
        entries.push_back({"full-naive-" + name, "paper-full-exact with " + form.instead, [name](const fs::path& work) {
                               Result<Candidate> candidate = paperFullExact(work);
                               if (candidate) candidate->naiveForm = name;
                               if (candidate) candidate->isDetail = true;
                               return candidate;
                           }});
    }
    return entries;
}

// One feature more than a simple shader has: paper+NAME on paper-parallel, film+NAME on physical-film-table.
void addFeature(std::vector<CandidateEntry>& entries, const std::string& name, const std::string& shows, Variant v)
{
    v.isDetail = true;
    entries.push_back({name, shows, of(v)});
}

std::vector<CandidateEntry> withFeatures(std::vector<CandidateEntry> entries)
{
    const auto changed = [](Variant v, const std::function<void(Features&)>& change) {
        v.change = change;
        return v;
    };
    Material withDiffuse = oneIndex(), noise = oneIndex();
    withDiffuse.diffuseWeight = 0.7;
    Material constant = oneIndex();
    constant.noiseOctaves = 0;
    Material constantDiffuse = constant;
    constantDiffuse.diffuseWeight = 0.7;
    Material indices = dispersive();
    indices.diffuseWeight = 0.0;
    Material normalised = oneIndex();
    normalised.lobes = Lobes::normalised;
    for (const bool isFilm : {false, true}) {
        const std::string base = isFilm ? "film" : "paper";
        const auto make = [&](const Material& material, bool tilt = false) { return isFilm ? film(material, tilt, Fringes::table) : paper(material, tilt); };
        const auto own = [&](const Material& material) {
            Variant v = make(material);
            v.options.thicknessMap = false;
            return v;
        };
        addFeature(entries, base + "+diffuse", "a diffuse part per pixel", make(withDiffuse));
        addFeature(entries, base + "+tilt", "boundaries that lean", make(oneIndex(), true));
        addFeature(entries, base + "+dispersion", "an index per channel", make(indices));
        addFeature(entries, base + "+total-reflection", "an index below the outside's", changed(make(oneIndex()), [](Features& f) { f.totalReflection = true; }));
        addFeature(entries, base + "+constant", "constant thickness instead of a map", own(constant));
        addFeature(entries, base + "+constant-diffuse", "constant thickness, and a diffuse part", own(constantDiffuse));
        addFeature(entries, base + "+noise", "the library's noise, three octaves, instead of a map", own(noise));
        addFeature(entries, base + "+stable-lobes", "lobes to the last digit", changed(make(oneIndex()), [](Features& f) { f.stableLobes = true; }));
        if (isFilm) {
            addFeature(entries, "film+metal", "a metal below", make(overGold(oneIndex())));
            addFeature(entries, "film+normalised", "normalised lobes", make(normalised));
        } else {
            addFeature(entries, "paper+split-phase", "the phase of a thick layer", changed(make(oneIndex()), [](Features& f) { f.splitPhase = true; }));
            addFeature(entries, "paper+polynomial-cosine", "the library's cosine", changed(make(oneIndex()), [](Features& f) { f.polynomialCosine = true; }));
        }
    }
    return entries;
}

}  // namespace

const std::vector<CandidateEntry>& candidateEntries()
{
    static const std::vector<CandidateEntry> entries = withNaiveForms(withFeatures({
        {std::string(flatName), "the inputs alone: what all others are measured against", flat},
        {"phong-lambert", "one Phong lobe and Lambert", phongLambert},
        {"lambert", "Lambert alone", lambert},
        {"diffuse-constant", "the diffuse part alone, of constant thickness", of(diffuseAlone())},
        {"paper-parallel", "specular part, parallel boundaries, one index", of(paper(oneIndex(), false))},
        {"paper-full", "tilt, index per channel, diffuse part", of(paper(dispersive(), true))},
        {"paper-parallel-exact", "paper-parallel with no error accepted", of(paper(oneIndex(), false, 0.0))},
        {"paper-full-exact", "paper-full with no error accepted", paperFullExact},
        {"paper-parallel-naive", "paper-parallel as the paper prints it", paperParallelNaive},
        {"paper-full-naive", "paper-full as the paper prints it", paperFullNaive},
        {"physical-film", "a film on a dielectric, specular part, parallel boundaries, one index, sampler-free", of(film(oneIndex(), false, Fringes::samplerFree))},
        {"physical-film-table", "the same with the fringe table", of(film(oneIndex(), false, Fringes::table))},
        {"physical-any", "a film on anything, timed over gold, sampler-free", of(film(overGold(oneIndex()), false, Fringes::samplerFree))},
        {"physical-any-table", "the same with the fringe table", of(film(overGold(oneIndex()), false, Fringes::table))},
        {"physical-full", "a film on a dielectric with tilt, index per channel, diffuse part, sampler-free", of(film(dispersive(), true, Fringes::samplerFree))},
        {"physical-full-table", "the same with the fringe table", of(film(dispersive(), true, Fringes::table))},
        {std::string(referenceName), "MeshPhysicalMaterial: metal and dielectric film once per pixel, GGX, Lambert", loadThreeJs},
        {"materialx-dielectric", "dielectric_bsdf: Airy film and GGX per light", loadMaterialXDielectric},
        {"materialx-surface", "standard_surface's base: metal and dielectric, each with the film, diffuse", loadMaterialXSurface},
    }));
    return entries;
}

}  // namespace nacre::bench
