// The spectral truth against other programs and published numbers, then the library against the truth.

#include <gtest/gtest.h>

#include <fstream>

#include "csv_table.hpp"
#include "film_error.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

const FringeTable& fringeTable()
{
    static const Result<FringeTable> table = FringeTable::create();
    return *table;
}

std::vector<double> errorsOf(FilmSet set, double leastNm, double mostNm, const FringeTable* table)
{
    return filmErrors(*randomFilms(set, 10000, 1, leastNm, mostNm), table);
}

// Made by check_tmm.py --data; both sum a few terms near 1 in double precision.
TEST(Truth, IsWhatTmmComputes)
{
    std::ifstream file(NACRE_TEST_DATA "/../spectral/data/tmm.csv");
    const Result<CsvTable> table = CsvTable::read(file);
    ASSERT_TRUE(table) << table.error().message;
    ASSERT_GE(table->rows.size(), 20U);
    for (std::size_t row = 0; row < table->rows.size(); ++row) {
        const auto cell = [&](const char* column) { return *number(*table, row, table->find(column)); };
        const Reflectance r = airy(cell("index"), {cell("substrate_n"), cell("substrate_k")}, cell("thickness_nm"), cell("cos_theta"),
                                   cell("wavelength_nm"));
        EXPECT_NEAR(r.s, cell("r_s"), 1e-12) << "row " << row;
        EXPECT_NEAR(r.p, cell("r_p"), 1e-12) << "row " << row;
    }
}

// Pairs 1, 4, 7, 10, 13, 16, 20, 25, 29, 34 of Sharma, Wu & Dalal 2005, table 1, printed to four decimals.
TEST(Truth, ColourDifferenceIsThePublishedOne)
{
    struct Pair {
        glm::dvec3 one, other;
        double difference;
    };
    for (const Pair& pair : {Pair{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425}, Pair{{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
                             Pair{{50, 0, 0}, {50, -1, 2}, 2.3669}, Pair{{50, 2.49, -0.001}, {50, -2.49, 0.001}, 7.1792},
                             Pair{{50, -0.001, 2.49}, {50, 0.0009, -2.49}, 4.8045}, Pair{{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
                             Pair{{50, 2.5, 0}, {58, 24, 15}, 19.4535}, Pair{{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                             Pair{{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
                             Pair{{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}}) {
        EXPECT_NEAR(ciede2000(pair.one, pair.other), pair.difference, 5e-5);
    }
}

TEST(Truth, FlatReflectanceIsGreyUnderBothLights)
{
    for (Illuminant illuminant : {Illuminant::equalEnergy, Illuminant::d65}) {
        const glm::dvec3 rgb = Observer(illuminant).colour([](double) { return 0.25; });
        for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(rgb[channel], 0.25, 1e-12);
    }
}

// Dispersion of 0.01 µm² is that of a dense flint: it moves the colours, so it is not passed over.
TEST(Truth, DispersionMovesTheColour)
{
    const auto glass = [](double) { return std::complex<double>(1.5); };
    const SpectralFilm flat{cauchy(1.7, 0.0), glass, 600.0, 0.7}, dispersive{cauchy(1.7, 0.01), glass, 600.0, 0.7};
    EXPECT_GT(colourDifference(Observer().colour(flat), Observer().colour(dispersive)), 2.0);
}

// The bars. Figures measured when they were set: 0.044, 0.20; 0.066; 0.18; 0.012.
TEST(FilmError, DielectricsWithTheTable)
{
    const ErrorFigures f = figures(errorsOf(FilmSet::dielectrics, 0.0, 800.0, &fringeTable()));
    EXPECT_LE(f.mean, 0.06);
    EXPECT_LE(f.percentile95, 0.3);
}

TEST(FilmError, DielectricsWithoutASampler)
{
    EXPECT_LE(figures(errorsOf(FilmSet::dielectrics, 0.0, 800.0, nullptr)).mean, 0.09);
}

TEST(FilmError, Metals)
{
    EXPECT_LE(figures(errorsOf(FilmSet::metals, 0.0, 800.0, &fringeTable())).mean, 0.25);
    EXPECT_LE(figures(errorsOf(FilmSet::metals, 0.0, 800.0, nullptr)).mean, 0.35);
}

TEST(FilmError, ThickFilms)
{
    EXPECT_LE(figures(errorsOf(FilmSet::dielectrics, 1000.0, 5000.0, &fringeTable())).mean, 0.05);
}

// No point of a sweep farther than 1: thickness to 1 µm, cosine from 0.05.
TEST(FilmError, NoPointOfASweepIsFar)
{
    for (const auto& [index, substrate] : {std::pair(1.33, 1.5), std::pair(1.5, 1.77), std::pair(1.9, 1.3), std::pair(1.5, 2.5)}) {
        const std::vector<FilmCase> films = sweep({index, {substrate, substrate, substrate}, {}, 0.0, 1.0}, 1000.0, 0.05);
        EXPECT_LE(figures(filmErrors(films, &fringeTable())).worst, 1.0) << index << " on " << substrate;
    }
}

}  // namespace
