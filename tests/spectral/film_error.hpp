#pragma once

#include <string>
#include <vector>

#include <nacre/fringe_table.hpp>

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
};

/// Film index 1.25 to 1.9, cosine 0.05 to 1, thickness between the bounds, all uniform. The same seed
/// gives the same films everywhere.
Result<std::vector<FilmCase>> randomFilms(FilmSet set, std::size_t count, unsigned seed, double leastNm, double mostNm);

/// Every film at thicknesses from 0 to mostNm and cosines from leastCosine to 1.
std::vector<FilmCase> sweep(const FilmCase& film, double mostNm, double leastCosine);

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

}  // namespace nacre::test
