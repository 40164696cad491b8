// The double-precision evaluation against the equations as printed, in 50 digits.

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <fstream>

#include "random_case.hpp"
#include "reference/paper.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;
using Wide = boost::multiprecision::cpp_bin_float_50;

std::vector<Case> vectorsOf(const char* name)
{
    std::ifstream file(std::string(NACRE_TEST_DATA "/") + name);
    return *readCases(*CsvTable::read(file));
}

double worst(const std::vector<Case>& cases)
{
    double worst = 0.0;
    for (const Case& one : cases) {
        const Printed<Wide> printed(one);
        const Evaluation e = *test::evaluate(one);
        for (int channel = 0; channel < 3; ++channel) {
            const auto k = static_cast<std::size_t>(channel);
            const double rho = static_cast<double>(printed.rho[k]);
            const double scale = std::max(1.0, rho);
            worst = std::max(worst, std::fabs(e.rho[channel] - rho) / scale);
            worst = std::max(worst, std::fabs(e.R[channel] - static_cast<double>(printed.R[k])) / scale);
            worst = std::max(worst, std::fabs(e.T[channel] - static_cast<double>(printed.T[k])) / scale);
            worst = std::max(worst, std::fabs(e.diffuse[channel] - static_cast<double>(printed.diffuse[k])));
            EXPECT_GE(e.rho[channel], 0.0);
        }
    }
    return worst;
}

// What was read as the paper's equations when the vectors were made is what is printed here, to the last of their
// digits: two implementations that share nothing.
TEST(Reference, PrintedEquationsGiveTheVectors)
{
    for (const char* name : {"typical.csv", "hard.csv"}) {
        std::ifstream file(std::string(NACRE_TEST_DATA "/") + name);
        const CsvTable table = *CsvTable::read(file);
        const std::vector<Case> cases = *readCases(table);
        for (std::size_t row = 0; row < cases.size(); ++row) {
            const Printed<Wide> printed(cases[row]);
            for (int channel = 0; channel < 3; ++channel) {
                const auto k = static_cast<std::size_t>(channel);
                const Wide expected(table.rows[row][table.find(std::string("rho_") + "rgb"[channel])]);
                // 23 digits are printed; the widest cancellation, a transmittance at 1e-6, costs both sides some.
                EXPECT_LT(abs(printed.rho[k] - expected), Wide(1e-18)) << name << ' ' << row << ' ' << channel;
            }
        }
    }
}

// Tolerances: those of the vectors, vectors_test.cpp.
TEST(Reference, DoubleAgreesOnTheVectors)
{
    EXPECT_LE(worst(vectorsOf("typical.csv")), 1e-12);
    EXPECT_LE(worst(vectorsOf("hard.csv")), 5e-11);
}

TEST(Reference, DoubleAgreesOnOtherCases)
{
    TypicalCases random(2003);
    std::vector<Case> cases;
    for (int i = 0; i < 5000; ++i) cases.push_back(random.next());
    EXPECT_LE(worst(cases), 1e-12);
}

}  // namespace
