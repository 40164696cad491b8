#pragma once

#include <functional>
#include <string>
#include <vector>

#include "candidate.hpp"
#include "render/image.hpp"

namespace nacre::bench {

/// One candidate over one film at thicknesses from 0 to 1000 nm and angles from 0 to 87 degrees.
struct SweepFigures {
    std::string film, candidate;
    test::ErrorFigures figures;
};

struct FilmSweep {
    demo::Image picture;
    std::vector<SweepFigures> figures;
    std::vector<std::string> missing;  ///< Candidates that the picture should show and that are not among those given.
};

/// Every film as its spectrum has it, as the qualities and forms of nacre and the peers draw it, and below
/// each of those a map of CIEDE2000. Thickness runs to the right, the angle upwards; each line is as bright on
/// average as any other, or the grazing ones would outshine all colours. progress: share done, 0 to 1.
Result<FilmSweep> sweepFilms(const std::vector<Candidate>& candidates, const std::function<void(double)>& progress);

/// The figures as a Markdown table.
std::string sweepTable(const FilmSweep& sweep);

}  // namespace nacre::bench
