#pragma once

#include <functional>
#include <vector>

#include "candidate.hpp"

namespace nacre::bench {

struct FilmPlan {
    std::size_t films = 10000;  ///< Of each set.
    unsigned seed = 1;
};

/// How far one candidate is from the spectrum over one set of films: CIEDE2000.
struct FilmError {
    std::size_t candidate = 0;
    std::size_t set = 0;  ///< Index in test::filmSets().
    test::ErrorFigures figures{};
    std::vector<test::Band> bands;
};

struct FilmReport {
    FilmPlan plan;
    std::vector<FilmError> errors;
    std::vector<Failure> failures;
};

/// Draws the films of every set with every candidate that models one and compares their colours with
/// spectral truth. A candidate fails whose colours are not finite or all the same, whose error no model
/// of a film has, or, of nacre's quality physical, whose error is not below every peer's.
/// progress: share done, 0 to 1. An error where there is no context or no set of films.
Result<FilmReport> measureFilms(const std::vector<Candidate>& candidates, const FilmPlan& plan, const std::function<void(double)>& progress);

/// A film that does not come from the library: another renderer's.
bool isPeer(const Candidate& candidate);

/// nacre's candidates of quality physical whose mean is not below that of every peer, set by set.
std::vector<Failure> beatenByPeers(const std::vector<Candidate>& candidates, const std::vector<FilmError>& errors);

/// Null where there is none.
const FilmError* find(const FilmReport& report, std::size_t candidate, std::size_t set);

}  // namespace nacre::bench
