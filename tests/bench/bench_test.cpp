// What nacre-bench measures errors with: that a film reaches a candidate's shader as it is, and that its checks
// notice what they are for. Films drawn by the GLSL are compared with the double-precision evaluation.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <nacre/evaluate.hpp>

#include "candidates.hpp"
#include "film_colour.hpp"
#include "film_report.hpp"
#include "gpu.hpp"
#include "label_layout.hpp"
#include "text_file.hpp"
#include "trade_off.hpp"

namespace nacre::bench {
namespace {

using test::context;
using test::FilmCase;

// None of the peers, which would be fetched.
Candidate load(const std::string& name)
{
    for (const CandidateEntry& entry : candidateEntries()) {
        if (entry.name != name) continue;
        Result<Candidate> candidate = entry.load({});
        EXPECT_TRUE(candidate) << candidate.error().message;
        if (!candidate) break;
        candidate->name = name;
        return *candidate;
    }
    ADD_FAILURE() << "no candidate " << name;
    return {};
}

std::vector<FilmCase> films(test::FilmSet set, std::size_t count = 700)
{
    return *test::randomFilms(set, count, 3, 0.0, 800.0);
}

glm::dvec3 evaluated(const FilmCase& film, Quality quality, const FringeTable* table)
{
    const double sine = std::sqrt(1.0 - film.cosTheta * film.cosTheta);
    return evaluate(test::materialOf(film, quality), {{0, 0, 1}, {0, 0, 1}, film.thicknessNm}, {sine, 0.0, film.cosTheta},
                    {-sine, 0.0, film.cosTheta}, table)->rho;
}

double farthest(const Candidate& candidate, const std::vector<FilmCase>& cases, Quality quality)
{
    Result<FilmProgram> program = FilmProgram::create(context().gl(), candidate);
    EXPECT_TRUE(program) << program.error().message;
    if (!program) return 1.0;
    const Result<std::vector<glm::dvec3>> colours = program->colours(cases);
    EXPECT_TRUE(colours) << colours.error().message;
    if (!colours) return 1.0;
    const Result<FringeTable> table = FringeTable::create();
    double worst = 0.0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const glm::dvec3 off = abs((*colours)[i] - evaluated(cases[i], quality, candidate.tables.empty() ? nullptr : &*table));
        for (int k = 0; k < 3; ++k) worst = std::isfinite(off[k]) ? std::fmax(worst, off[k]) : 1.0;
    }
    return worst;
}

// float32 inputs and arithmetic at up to 3 cycles of phase: 1e-5. Eight bits of the table are 1 / 55 / 2 = 9e-3 of a
// fringe, which a metal at grazing angles, where |q| reaches 0.9, weighs by up to 10.
TEST(FilmColour, IsWhatTheLibraryEvaluates)
{
    EXPECT_LT(farthest(load("physical-film"), films(test::FilmSet::dielectrics), Quality::physical), 1e-4);
    EXPECT_LT(farthest(load("physical-full"), films(test::FilmSet::dielectrics), Quality::physical), 1e-4);
    EXPECT_LT(farthest(load("physical-any"), films(test::FilmSet::dielectrics), Quality::physical), 1e-4);
    EXPECT_LT(farthest(load("physical-any"), films(test::FilmSet::metals), Quality::physical), 1e-4);
    EXPECT_LT(farthest(load("physical-any-table"), films(test::FilmSet::metals), Quality::physical), 1e-2);
    EXPECT_LT(farthest(load("paper-full"), films(test::FilmSet::dielectrics), Quality::paper), 1e-4);
    EXPECT_LT(farthest(load("paper-parallel"), films(test::FilmSet::metals), Quality::paper), 1e-4);
}

// Films of one material are drawn together, and a picture ends in a row that is not full.
TEST(FilmColour, DoesNotDependOnNeighbours)
{
    std::vector<FilmCase> cases = films(test::FilmSet::metals, 3);
    for (std::size_t i = 0; i < 1500; ++i) {
        cases.push_back(cases[i / 400 % 3]);
        cases.back().thicknessNm = 0.5 * static_cast<double>(i);
    }
    EXPECT_LT(farthest(load("physical-any"), cases, Quality::physical), 1e-4);
}

std::vector<std::string> failures(const std::vector<Candidate>& candidates)
{
    const Result<FilmReport> report = measureFilms(candidates, {150, 1}, [](double) {});
    EXPECT_TRUE(report) << report.error().message;
    std::vector<std::string> messages;
    if (report) {
        for (const Failure& failure : report->failures) messages.push_back(failure.candidate + ": " + failure.message);
    }
    return messages;
}

Candidate withFilm(Candidate candidate, const std::string& result)
{
    candidate.film.glsl = replaced(candidate.film.glsl, "bench_film(bench_Film f)", "bench_filmItself(bench_Film f)") +
                          "vec3 bench_film(bench_Film f) { " + result + " }\n";
    return candidate;
}

TEST(FilmReport, AcceptsTheLibrary)
{
    EXPECT_EQ(failures({load("physical-film"), load("physical-any-table"), load("paper-parallel")}), std::vector<std::string>{});
}

TEST(FilmReport, NoticesColoursThatAreNone)
{
    const Candidate film = load("physical-film");
    for (const char* broken : {"return bench_filmItself(f) / (f.index - f.index);", "return vec3(0.3);", "return vec3(f.cosTheta);",
                               "f.thicknessUm *= 3.0; return bench_filmItself(f).bgr;"}) {
        EXPECT_FALSE(failures({withFilm(film, broken)}).empty()) << broken;
    }
    EXPECT_FALSE(failures({withFilm(film, "this is no GLSL")}).empty());
}

TEST(FilmReport, NoticesThatAPeerIsCloser)
{
    std::vector<Candidate> candidates(3);
    for (Candidate& candidate : candidates) candidate.film.glsl = "a film";
    candidates[0].name = "own";
    candidates[1].film.hasSubstrate = false;  // the paper's mirror is far from every substrate
    candidates[2].name = "peer";
    candidates[2].usesLibrary = false;
    const auto error = [](std::size_t candidate, std::size_t set, double mean) { return FilmError{candidate, set, {mean, mean, mean, 0, 1}, {}}; };
    const std::vector<FilmError> errors{error(0, 0, 0.1), error(0, 1, 3.0), error(1, 0, 40.0), error(2, 0, 2.0), error(2, 1, 2.5)};
    const std::vector<Failure> failures = beatenByPeers(candidates, errors);
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures[0].candidate, "own");
    EXPECT_EQ(failures[0].message, std::string(test::filmSets()[1].name) + ": expected a mean below peer's 2.500, got 3.000");
}

TEST(Front, HasThoseThatNoneBeats)
{
    const Measured cost{1.0, 2.0, 3.0, 4.0, std::nullopt, 0.5}, error{5.0, 1.0, 2.0, 0.5, 0.1, std::nullopt};
    EXPECT_EQ(onFront(cost, error), (std::vector<bool>{true, true, false, true, false, false}));
    // As close but for rounding, and slower: not on it.
    EXPECT_EQ(onFront({1.0, 2.0}, {0.1, 0.0999}), (std::vector<bool>{true, false}));
    EXPECT_EQ(onFront({1.0, 1.0}, {0.1, 0.1}), (std::vector<bool>{true, true}));
}

TEST(LabelLayout, NoLabelLiesOnAnother)
{
    std::mt19937 random(1);
    std::vector<LabelledPoint> points;
    const auto within = [&](unsigned range) { return static_cast<double>(random() % range); };
    for (int i = 0; i < 20; ++i) points.push_back({100.0 + within(400), 300.0 + within(60), "a label's text"});
    const Box frame{0.0, 0.0, 800.0, 700.0};
    const std::vector<PlacedLabel> labels = placeLabels(points, frame, 7.0, 16.0);
    ASSERT_EQ(labels.size(), points.size());
    const auto box = [](const PlacedLabel& label) { return Box{label.x, label.y - 8.0, label.x + 14 * 7.0, label.y + 8.0}; };
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(box(labels[i]).overlaps(box(labels[j]))) << i << ' ' << j;
        EXPECT_GE(box(labels[i]).left, frame.left);
        EXPECT_LE(box(labels[i]).right, frame.right);
    }
}

}  // namespace
}  // namespace nacre::bench
