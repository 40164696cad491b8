// The one list of all candidates. To add one:
//   1. put its GLSL into glsl/NAME.glsl: struct bench_View, bench_view(), bench_light(); see candidate.hpp;
//   2. add a line to candidateEntries() below;
//   3. if it reads nothing but nacre_Block, its function is one line, library("NAME.glsl", material);
//      else fill Candidate: a block of its own (blockName, block), tables (sampler, size, filter, texels).
//   4. if it models a film, it has a FilmHook, or its errors are left out: layer() in place of library() where
//      view and light are the library's; else GLSL with bench_film(), glsl/film.glsl.
// Each of the library's stable forms made naive by itself is a candidate too, full-naive-NAME, from
// naiveForms(). --candidates and the report take up the names by themselves.

#include "candidates.hpp"

#include <nacre/block.hpp>
#include <nacre/fringe_table.hpp>
#include <nacre/presets.hpp>

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

// Quality physical over a dielectric, or over any substrate, compiled for metals too and timed over gold.
// filmOnly: no tilt, no diffuse part, and over a dielectric one index for all channels.
Result<Candidate> physicalFilm(bool filmOnly, bool withTable, bool hasMetals = false)
{
    Material material = filmOnly ? oneIndex() : dispersive();
    material.quality = Quality::physical;
    if (hasMetals) {
        material.substrate = Substrate::metal;
        material.substrateIndex = {0.155, 0.425, 1.345};
        material.substrateAbsorption = {3.484, 2.453, 1.773};
    }
    Result<Candidate> candidate = layer("physical.glsl", material);
    if (!candidate) return candidate;
    candidate->film.hasMetals = hasMetals;
    const auto define = [](const char* name, bool value) { return std::string("#define ") + name + (value ? " 1\n" : " 0\n"); };
    candidate->glsl = define("BENCH_FILM_ONLY", filmOnly) + define("BENCH_TABLE", withTable) + candidate->glsl;
    candidate->switches = define("NACRE_METAL", hasMetals) + define("NACRE_NORMALISED", false);
    if (filmOnly) candidate->switches += define("NACRE_TILT", false) + define("NACRE_DISPERSION", hasMetals);
    if (withTable) {
        Result<FringeTable> fringes = FringeTable::create();
        if (!fringes) return fringes.error();
        Table table;
        table.sampler = "bench_fringeTable";
        table.width = FringeTable::width;
        table.height = FringeTable::height;
        table.format = Table::Format::unorm8;
        table.texels.assign(fringes->texels().begin(), fringes->texels().end());
        candidate->tables.push_back(table);
    }
    return candidate;
}

Result<Candidate> physicalAnalytic(const fs::path&) { return physicalFilm(true, false); }
Result<Candidate> physicalTable(const fs::path&) { return physicalFilm(true, true); }
Result<Candidate> physicalAny(const fs::path&) { return physicalFilm(true, false, true); }
Result<Candidate> physicalAnyTable(const fs::path&) { return physicalFilm(true, true, true); }
Result<Candidate> physicalFullAnalytic(const fs::path&) { return physicalFilm(false, false); }
Result<Candidate> physicalFullTable(const fs::path&) { return physicalFilm(false, true); }

Result<Candidate> phongLambert(const fs::path&) { return library("phong_lambert.glsl", dispersive()); }
Result<Candidate> paperFull(const fs::path&) { return layer("paper_full.glsl", dispersive()); }

Result<Candidate> paperFullNaive(const fs::path&) { return layer("paper_full_naive.glsl", dispersive()); }
Result<Candidate> paperParallel(const fs::path&) { return layer("paper_parallel.glsl", oneIndex()); }
Result<Candidate> paperParallelNaive(const fs::path&) { return layer("paper_parallel_naive.glsl", oneIndex()); }

std::vector<CandidateEntry> withNaiveForms(std::vector<CandidateEntry> entries)
{
    for (const test::NaiveForm& form : test::naiveForms()) {
        const std::string name = form.name;
        entries.push_back({"full-naive-" + name, "paper-full with " + form.instead, [name](const fs::path& work) {
                               Result<Candidate> candidate = paperFull(work);
                               if (candidate) candidate->naiveForm = name;
                               return candidate;
                           }});
    }
    return entries;
}

}  // namespace

const std::vector<CandidateEntry>& candidateEntries()
{
    static const std::vector<CandidateEntry> entries = withNaiveForms({
        {std::string(flatName), "the inputs alone: what all others are measured against", flat},
        {"phong-lambert", "one Phong lobe and Lambert", phongLambert},
        {"paper-full", "nacre as it is: tilted boundary, index per channel, diffuse", paperFull},
        {"paper-full-naive", "paper-full as the paper prints it", paperFullNaive},
        {"paper-parallel", "parallel boundaries, one index, specular, in nacre's stable forms", paperParallel},
        {"paper-parallel-naive", "paper-parallel as the paper prints it", paperParallelNaive},
        {"physical-film", "quality physical, sampler-free: parallel boundaries, one index, dielectric, specular", physicalAnalytic},
        {"physical-film-table", "the same with the fringe table, 8 bits, linear", physicalTable},
        {"physical-any", "quality physical, sampler-free: parallel boundaries, index per channel, any substrate, specular", physicalAny},
        {"physical-any-table", "the same with the fringe table, 8 bits, linear", physicalAnyTable},
        {"physical-full", "quality physical, sampler-free: tilt, index per channel, dielectric, diffuse", physicalFullAnalytic},
        {"physical-full-table", "the same with the fringe table, 8 bits, linear", physicalFullTable},
        {std::string(referenceName), "MeshPhysicalMaterial: metal and dielectric film once per pixel, GGX, Lambert", loadThreeJs},
        {"materialx-dielectric", "dielectric_bsdf: Airy film and GGX per light", loadMaterialXDielectric},
        {"materialx-surface", "standard_surface's base: metal and dielectric, each with the film, diffuse", loadMaterialXSurface},
    });
    return entries;
}

}  // namespace nacre::bench
