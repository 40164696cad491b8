#include "film_error.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

std::function<double(double)> indexOf(const FilmCase& film)
{
    if (film.dispersionUm2 == 0.0) return [n = film.index](double) { return n; };  // to the last bit in every channel
    return cauchy(film.index - film.dispersionUm2 / (0.525 * 0.525), film.dispersionUm2);
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

const std::vector<NamedSet>& filmSets()
{
    static const std::vector<NamedSet> sets{
        {"dielectrics, 0-800 nm", FilmSet::dielectrics, 0.0, 800.0, 100.0},
        {"metals, 0-800 nm, n and k per channel", FilmSet::metals, 0.0, 800.0, 100.0},
        {"metals, 0-800 nm, n and k by wavelength", FilmSet::measuredMetals, 0.0, 800.0, 100.0},
        {"dielectrics, 1-5 um", FilmSet::dielectrics, 1000.0, 5000.0, 1000.0},
        {"metals, 1-5 um, n and k per channel", FilmSet::metals, 1000.0, 5000.0, 1000.0},
    };
    return sets;
}

Material materialOf(const FilmCase& film, Quality quality)
{
    Material material;
    material.quality = quality;
    for (int channel = 0; channel < 3; ++channel) material.ior[channel] = indexOf(film)(channelNm[channel]);
    material.upperExponent = material.lowerExponent = 0.0;
    material.diffuseWeight = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        material.substrateIndex[channel] = film.substrate[channel].real();
        material.substrateAbsorption[channel] = film.substrate[channel].imag();
        if (film.substrate[channel].imag() != 0.0) material.substrate = Substrate::metal;
    }
    return material;
}

glm::dvec3 libraryColour(const FilmCase& film, const FringeTable* table)
{
    const Material material = materialOf(film, Quality::physical);
    const double sine = std::sqrt(1.0 - film.cosTheta * film.cosTheta);
    const Result<Evaluation> evaluation = evaluate(material, {{0, 0, 1}, {0, 0, 1}, film.thicknessNm}, {sine, 0.0, film.cosTheta},
                                                   {-sine, 0.0, film.cosTheta}, table);
    return evaluation ? evaluation->rho : glm::dvec3(std::nan(""));
}

glm::dvec3 trueColour(const FilmCase& film, const Observer& observer)
{
    const auto index = indexOf(film);
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

std::vector<Band> byThickness(const std::vector<FilmCase>& films, const std::vector<double>& errors, double bandNm)
{
    std::map<int, std::vector<double>> errorsOf;
    for (std::size_t i = 0; i < films.size(); ++i) errorsOf[static_cast<int>(films[i].thicknessNm / bandNm)].push_back(errors[i]);
    std::vector<Band> bands;
    for (const auto& [band, one] : errorsOf) bands.push_back({band * bandNm, (band + 1) * bandNm, figures(one)});
    return bands;
}

}  // namespace nacre::test
