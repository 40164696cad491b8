#pragma once

#include <string>
#include <vector>

#include <nacre/fringe_table.hpp>
#include <nacre/material.hpp>

#include "spectral.hpp"

namespace nacre::test {

/// What lies below the random films of a set.
enum class FilmSet {
    dielectrics,     ///< Index 1.3 to 3.
    metals,          ///< Al, Cu, Au, Fe; n and k constant within each channel, as the material has them.
    measuredMetals,  ///< The same with n(λ), k(λ): what three channels cannot hold.
};

/// A film, lit and seen in the mirror direction.
struct FilmCase {
    double index;
    std::complex<double> substrate[3];  ///< At 645, 525, 445 nm.
    std::function<std::complex<double>(double)> measured;  ///< Empty but for measured metals.
    double thicknessNm, cosTheta;
    double dispersionUm2 = 0.0;  ///< b of Cauchy's n(λ) = a + b / λ²; `index` is then the one at 525 nm.
};

/// Film index 1.25 to 1.9, cosine 0.05 to 1, thickness between the bounds, all uniform. The same seed
/// gives the same films everywhere.
Result<std::vector<FilmCase>> randomFilms(FilmSet set, std::size_t count, unsigned seed, double leastNm, double mostNm);

/// A set under a name, with its thicknesses.
struct NamedSet {
    const char* name;
    FilmSet set;
    double leastNm, mostNm;
    double bandNm;  ///< By how much thicknesses are told apart.
};
/// All that are reported on; the first is what candidates are compared by.
const std::vector<NamedSet>& filmSets();

/// Every film at thicknesses from 0 to mostNm and cosines from leastCosine to 1.
std::vector<FilmCase> sweep(const FilmCase& film, double mostNm, double leastCosine);

/// The material that the library takes it for: no diffuse part, lobes that are 1 everywhere.
Material materialOf(const FilmCase& film, Quality quality);
/// The colour that the library gives it, quality physical; without a table: the sampler-free form.
glm::dvec3 libraryColour(const FilmCase& film, const FringeTable* table);
/// Its colour by the spectrum.
glm::dvec3 trueColour(const FilmCase& film, const Observer& observer);

/// CIEDE2000 over a set.
struct ErrorFigures {
    double mean, percentile95, worst;
    std::size_t worstAt, count;
};
ErrorFigures figures(const std::vector<double>& errors);

/// The error of each film.
std::vector<double> filmErrors(const std::vector<FilmCase>& films, const FringeTable* table);

/// The figures of all films of a band of thicknesses.
struct Band {
    double leastNm, mostNm;
    ErrorFigures figures;  ///< worstAt counts within the band.
};
/// errors[i] is that of films[i]; bands without a film are left out.
std::vector<Band> byThickness(const std::vector<FilmCase>& films, const std::vector<double>& errors, double bandNm);

}  // namespace nacre::test
