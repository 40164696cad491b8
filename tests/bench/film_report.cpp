#include "film_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "film_colour.hpp"
#include "gl_candidate.hpp"

namespace nacre::bench {
namespace {

using test::FilmCase;

std::string fixed(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

// Colours and truth are compared film by film; by `shift` a film with the truth of another one.
std::vector<double> differences(const std::vector<glm::dvec3>& colours, const std::vector<glm::dvec3>& truth, std::size_t shift = 0)
{
    std::vector<double> values(colours.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = test::colourDifference(colours[i], truth[(i + shift) % truth.size()]);
    return values;
}

// Why colours cannot be those of the films; empty where they can. A candidate that does not see its films, or
// other ones, is as far from them as from any others: one that models them is well below that. Of that distance
// three.js and MaterialX keep 0.18 at most on dielectrics, 0.52 on metals, which are more alike.
std::string faultOf(const FilmHook& hook, test::FilmSet set, const std::vector<glm::dvec3>& colours, const std::vector<glm::dvec3>& truth,
                    double mean)
{
    const double mostOfOthers = set == test::FilmSet::dielectrics ? 0.4 : 0.75;
    const auto isFinite = [](glm::dvec3 c) { return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z); };
    if (!std::all_of(colours.begin(), colours.end(), isFinite)) return "a film's colour is not finite";
    if (!hook.hasSubstrate || colours.size() < 2) return {};
    const double others = test::figures(differences(colours, truth, 1)).mean;
    if (mean < mostOfOthers * others) return {};
    return "its colours are no films': mean difference " + fixed(mean) + " to their own, " + fixed(others) + " to other films";
}

}  // namespace

Result<FilmReport> measureFilms(const std::vector<Candidate>& candidates, const FilmPlan& plan, const std::function<void(double)>& progress)
{
    drawInCallingThread();  // times may be taken after this
    Result<demo::Context> context = demo::Context::create();
    if (!context) return context.error();
    FilmReport report;
    report.plan = plan;

    struct Films {
        std::vector<FilmCase> cases;
        std::vector<glm::dvec3> truth;
    };
    std::vector<Films> sets;
    const test::Observer observer;
    const double steps = static_cast<double>(test::filmSets().size() + candidates.size());
    for (const test::NamedSet& set : test::filmSets()) {
        Result<std::vector<FilmCase>> cases = test::randomFilms(set.set, plan.films, plan.seed, set.leastNm, set.mostNm);
        if (!cases) return cases.error();
        Films films{*cases, {}};
        for (const FilmCase& film : films.cases) films.truth.push_back(test::trueColour(film, observer));
        sets.push_back(films);
        progress(static_cast<double>(sets.size()) / steps);
    }

    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate& candidate = candidates[i];
        if (candidate.film.glsl.empty()) continue;
        const auto fail = [&](const std::string& message) { report.failures.push_back({candidate.name, message}); };
        Result<FilmProgram> program = FilmProgram::create(context->gl(), candidate);
        if (!program) {
            fail(program.error().message);
            continue;
        }
        for (std::size_t set = 0; set < sets.size(); ++set) {
            const test::NamedSet& named = test::filmSets()[set];
            if (named.set != test::FilmSet::dielectrics && !candidate.film.hasMetals) continue;
            Result<std::vector<glm::dvec3>> colours = program->colours(sets[set].cases);
            if (!colours) {
                fail(colours.error().message);
                break;
            }
            const std::vector<double> errors = differences(*colours, sets[set].truth);
            const FilmError error{i, set, test::figures(errors), test::byThickness(sets[set].cases, errors, named.bandNm)};
            if (const std::string fault = faultOf(candidate.film, named.set, *colours, sets[set].truth, error.figures.mean); !fault.empty()) {
                fail(std::string(named.name) + ": " + fault);
                continue;
            }
            report.errors.push_back(error);
        }
        progress(static_cast<double>(sets.size() + i + 1) / steps);
    }
    const std::vector<Failure> beaten = beatenByPeers(candidates, report.errors);
    report.failures.insert(report.failures.end(), beaten.begin(), beaten.end());
    return report;
}

std::vector<Failure> beatenByPeers(const std::vector<Candidate>& candidates, const std::vector<FilmError>& errors)
{
    std::vector<Failure> failures;
    for (const FilmError& error : errors) {
        const Candidate& own = candidates[error.candidate];
        if (!own.usesLibrary || !own.film.hasSubstrate) continue;
        for (const FilmError& other : errors) {
            if (other.set != error.set || !isPeer(candidates[other.candidate])) continue;
            if (error.figures.mean < other.figures.mean) continue;
            failures.push_back({own.name, std::string(test::filmSets()[error.set].name) + ": expected a mean below " +
                                              candidates[other.candidate].name + "'s " + fixed(other.figures.mean) + ", got " +
                                              fixed(error.figures.mean)});
        }
    }
    return failures;
}

bool isPeer(const Candidate& candidate)
{
    return !candidate.usesLibrary && !candidate.film.glsl.empty();
}

const FilmError* find(const FilmReport& report, std::size_t candidate, std::size_t set)
{
    const auto isIt = [&](const FilmError& error) { return error.candidate == candidate && error.set == set; };
    const auto found = std::find_if(report.errors.begin(), report.errors.end(), isIt);
    return found == report.errors.end() ? nullptr : &*found;
}

}  // namespace nacre::bench
