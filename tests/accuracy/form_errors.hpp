#pragma once

#include <string>
#include <vector>

#include "gl/context.hpp"

namespace nacre::test {

/// What a cheap form of one part errs at most where it is chosen, beside what lib/src/form_bounds.hpp states.
struct FormError {
    std::string form, unit;
    double from, upTo;  ///< of what the error depends on, in that unit
    double worst, stated;
};

/// All of them on one driver, each part's cheap form by itself. cases: of each range.
Result<std::vector<FormError>> measureForms(const demo::Context& context, std::size_t cases, std::uint64_t seed);

}  // namespace nacre::test
