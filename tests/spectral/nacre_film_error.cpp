// How far quality physical is from the spectrum: see --help.

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>

#include "csv_table.hpp"
#include "film_error.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

void print(const std::string& name, const ErrorFigures& f)
{
    std::printf("%-44s %7zu %8.3f %8.3f %8.2f\n", name.c_str(), f.count, f.mean, f.percentile95, f.worst);
}

// All films of a set, then by bands of 100 nm; thick ones by 1 µm.
void report(const std::string& name, const std::vector<FilmCase>& films, const FringeTable* table, double bandNm)
{
    const std::vector<double> errors = filmErrors(films, table);
    print(name, figures(errors));
    for (const Band& band : byThickness(films, errors, bandNm)) {
        char where[40];
        std::snprintf(where, sizeof where, "    %g-%g nm", band.leastNm, band.mostNm);
        print(where, band.figures);
    }
}

void reportSweep(const std::string& name, double index, const std::function<std::complex<double>(double)>& substrate, double leastCosine,
                 const FringeTable* table)
{
    const FilmCase film{index, {substrate(645.0), substrate(525.0), substrate(445.0)}, {}, 0.0, 1.0};
    const std::vector<FilmCase> films = sweep(film, 1000.0, leastCosine);
    const ErrorFigures f = figures(filmErrors(films, table));
    char where[80];
    std::snprintf(where, sizeof where, " (worst: %g nm, cosine %.3g)", films[f.worstAt].thicknessNm, films[f.worstAt].cosTheta);
    print(name + where, f);
}

int fail(const Error& error)
{
    std::cerr << "nacre-film-error: " << error.message << '\n';
    return 1;
}

// The truth alone, for a comparison with other programs.
int reflectances()
{
    Result<CsvTable> table = CsvTable::read(std::cin);
    if (!table) return fail(table.error());
    std::puts("r_s,r_p");
    for (std::size_t row = 0; row < table->rows.size(); ++row) {
        double value[6];
        const char* const columns[] = {"index", "substrate_n", "substrate_k", "thickness_nm", "cos_theta", "wavelength_nm"};
        for (std::size_t i = 0; i < 6; ++i) {
            const std::size_t at = table->find(columns[i]);
            if (at == table->columns.size()) return fail({std::string("expected a column ") + columns[i]});
            Result<double> cell = number(*table, row, at);
            if (!cell) return fail(cell.error());
            value[i] = *cell;
        }
        const Reflectance r = airy(value[0], {value[1], value[2]}, value[3], value[4], value[5]);
        std::printf("%.17g,%.17g\n", r.s, r.p);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{"CIEDE2000 between quality physical and the spectrum, over random films: mean, 95th percentile, worst."};
    std::string form = "table";
    std::size_t count = 10000;
    unsigned seed = 1;
    bool onlyReflectances = false;
    app.add_option("--form", form, "table or analytic")->check(CLI::IsMember({"table", "analytic"}))->capture_default_str();
    app.add_option("--count", count, "films of each set")->capture_default_str();
    app.add_option("--seed", seed)->capture_default_str();
    app.add_flag("--reflectances", onlyReflectances,
                 "read CSV with index, substrate_n, substrate_k, thickness_nm, cos_theta, wavelength_nm; write the exact r_s, r_p");
    CLI11_PARSE(app, argc, argv);
    if (onlyReflectances) return reflectances();

    Result<FringeTable> created = FringeTable::create();
    if (!created) return fail(created.error());
    const FringeTable* table = form == "table" ? &*created : nullptr;

    std::printf("%-44s %7s %8s %8s %8s\n", ("fringes: " + form).c_str(), "films", "mean", "95 %", "worst");
    for (const NamedSet& set : filmSets()) {
        Result<std::vector<FilmCase>> films = randomFilms(set.set, count, seed, set.leastNm, set.mostNm);
        if (!films) return fail(films.error());
        report(set.name, *films, table, set.bandNm);
    }
    // What the channels' own indices make of a film whose index changes within them too: crown glass has 0.004 um2, flint 0.013.
    for (const double dispersion : {0.004, 0.013}) {
        const NamedSet& set = filmSets().front();
        Result<std::vector<FilmCase>> films = randomFilms(set.set, count, seed, set.leastNm, set.mostNm);
        if (!films) return fail(films.error());
        for (FilmCase& film : *films) film.dispersionUm2 = dispersion;
        print(std::string(set.name) + ", Cauchy's b " + std::to_string(dispersion).substr(0, 5) + " um2", figures(filmErrors(*films, table)));
    }
    std::puts("thickness 0-1000 nm x angle");
    const auto constant = [](double n) { return [n](double) { return std::complex<double>(n); }; };
    reportSweep("1.33 on 1.5", 1.33, constant(1.5), 0.05, table);
    reportSweep("1.5 on 1.77", 1.5, constant(1.77), 0.05, table);
    reportSweep("1.9 on 1.3", 1.9, constant(1.3), 0.05, table);
    reportSweep("1.5 on 2.5", 1.5, constant(2.5), 0.05, table);
    reportSweep("1.25 on 3", 1.25, constant(3.0), 0.05, table);
    for (const char* name : {"al", "cu", "au", "fe"}) {
        Result<std::function<std::complex<double>(double)>> substrate = metal(name);
        if (!substrate) return fail(substrate.error());
        reportSweep(std::string("1.5 on ") + name, 1.5, *substrate, 0.05, table);
        reportSweep(std::string("1.5 on ") + name + ", cosine >= 0.3", 1.5, *substrate, 0.3, table);
    }
    return 0;
}
