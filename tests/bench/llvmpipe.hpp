#pragma once

#include <functional>
#include <vector>

#include "candidate.hpp"
#include "statistics.hpp"

namespace nacre::bench {

struct LlvmpipePlan {
    std::vector<int> lights{1};
    std::vector<double> megapixels{1.0};
    int rounds = 15;
    bool halfFloat = false;  ///< RGBA16F instead of RGBA32F.
};

/// One candidate under one number of lights and pixels. Each number is taken per round, in which the
/// candidates follow one another, and then summed up over the rounds: a machine that slows down for a
/// while changes both sides of a difference alike.
struct LlvmpipeTime {
    std::size_t candidate = 0;
    int lights = 0;
    double megapixels = 0.0;
    Summary nsPerPixel;
    Summary increment;  ///< Over flat, ns per pixel.
    Summary ratio;      ///< Of the increments, to three.js; count 0 where that is missing.
};

struct LlvmpipeReport {
    std::string renderer;
    std::vector<LlvmpipeTime> times;
    std::vector<Failure> failures;
};

/// Measures fragment shaders on llvmpipe in this thread alone; candidates[0] is flat, candidates[reference]
/// three.js (any index beyond the last: there is none). A picture that is
/// constant, not finite, or the same without the candidate's block or one of its tables, fails that
/// candidate. progress: share done, 0 to 1.
/// An error where there is no context, or it is not llvmpipe's.
Result<LlvmpipeReport> measureLlvmpipe(const std::vector<Candidate>& candidates, std::size_t reference, const LlvmpipePlan& plan,
                                       const std::function<void(double)>& progress);

}  // namespace nacre::bench
