#include "film_error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <nacre/evaluate.hpp>

namespace nacre::test {
namespace {

constexpr double channelNm[] = {645.0, 525.0, 445.0};

// The standard's distributions differ between libraries; its generators do not.
double uniform(std::mt19937_64& random, double least, double most)
{
    return least + (most - least) * static_cast<double>(random() >> 11U) * 0x1p-53;
}

}  // namespace

Result<std::vector<FilmCase>> randomFilms(FilmSet set, std::size_t count, unsigned seed, double leastNm, double mostNm)
{
    std::vector<std::function<std::complex<double>(double)>> metals;
    for (const char* name : {"al", "cu", "au", "fe"}) {
        Result<std::function<std::complex<double>(double)>> one = metal(name);
        if (!one) return one.error();
        metals.push_back(*one);
    }
    std::mt19937_64 random(seed);
    std::vector<FilmCase> films(count);
    for (FilmCase& film : films) {
        film.index = uniform(random, 1.25, 1.9);
        film.thicknessNm = uniform(random, leastNm, mostNm);
        film.cosTheta = uniform(random, 0.05, 1.0);
        if (set == FilmSet::dielectrics) {
            std::fill_n(film.substrate, 3, uniform(random, 1.3, 3.0));
        } else {
            const auto& metal = metals[random() % metals.size()];
            for (int channel = 0; channel < 3; ++channel) film.substrate[channel] = metal(channelNm[channel]);
            if (set == FilmSet::measuredMetals) film.measured = metal;
        }
    }
    return films;
}

std::vector<FilmCase> sweep(const FilmCase& film, double mostNm, double leastCosine)
{
    constexpr int thicknesses = 200, cosines = 40;
    std::vector<FilmCase> films;
    for (int i = 0; i <= thicknesses; ++i) {
        for (int j = 0; j <= cosines; ++j) {
            films.push_back(film);
            films.back().thicknessNm = mostNm * i / thicknesses;
            films.back().cosTheta = leastCosine + (1.0 - leastCosine) * j / cosines;
        }
    }
    return films;
}

glm::dvec3 libraryColour(const FilmCase& film, const FringeTable* table)
{
    Material material;
    material.quality = Quality::physical;
    material.ior = glm::dvec3(film.index);
    material.upperExponent = material.lowerExponent = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        material.substrateIndex[channel] = film.substrate[channel].real();
        material.substrateAbsorption[channel] = film.substrate[channel].imag();
        if (film.substrate[channel].imag() != 0.0) material.substrate = Substrate::metal;
    }
    const double sine = std::sqrt(1.0 - film.cosTheta * film.cosTheta);
    const Result<Evaluation> evaluation = evaluate(material, {{0, 0, 1}, {0, 0, 1}, film.thicknessNm}, {sine, 0.0, film.cosTheta},
                                                   {-sine, 0.0, film.cosTheta}, table);
    return evaluation ? evaluation->rho : glm::dvec3(std::nan(""));
}

glm::dvec3 trueColour(const FilmCase& film, const Observer& observer)
{
    const auto index = [&](double) { return film.index; };
    const auto colour = [&](const std::function<std::complex<double>(double)>& substrate) {
        return observer.colour(SpectralFilm{index, substrate, film.thicknessNm, film.cosTheta});
    };
    if (film.measured) return colour(film.measured);
    const bool isGrey = film.substrate[0] == film.substrate[1] && film.substrate[0] == film.substrate[2];
    glm::dvec3 rgb = colour([&](double) { return film.substrate[0]; });
    if (isGrey) return rgb;
    for (int channel = 1; channel < 3; ++channel) {
        rgb[channel] = colour([&](double) { return film.substrate[channel]; })[channel];
    }
    return rgb;
}

ErrorFigures figures(const std::vector<double>& errors)
{
    std::vector<double> sorted = errors;
    std::sort(sorted.begin(), sorted.end());
    const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(sorted.size()))) - 1;
    const auto worst = std::max_element(errors.begin(), errors.end());
    return {std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size()), sorted[rank], *worst,
            static_cast<std::size_t>(worst - errors.begin()), errors.size()};
}

std::vector<double> filmErrors(const std::vector<FilmCase>& films, const FringeTable* table)
{
    const Observer observer;
    std::vector<double> errors(films.size());
    std::transform(films.begin(), films.end(), errors.begin(),
                   [&](const FilmCase& film) { return colourDifference(libraryColour(film, table), trueColour(film, observer)); });
    return errors;
}

}  // namespace nacre::test
