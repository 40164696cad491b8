#pragma once

#include <string>
#include <vector>

#include "measure.hpp"

namespace nacre::test {

/// One table of ρ and one of the diffuse coefficient; then the worst cases of ρ as CSV for nacre-eval.
std::string markdown(const std::vector<Measurement>& measurements);

/// Measurements of naive forms, named by their driver, against those of the GLSL as it is, which come first: the
/// 99.9th percentile of ρ, a form a row and a region a column.
std::string formsMarkdown(const std::vector<Measurement>& measurements);

/// Everything measured, a row each, with the input of its worst case: nacre-eval reads it too.
std::string csv(const std::vector<Measurement>& measurements);

/// The other way round. Errors: columns that csv() does not write.
Result<std::vector<Measurement>> readMeasurements(const std::string& csv);

/// Has gnuplot draw the errors of ρ, from the median to the worst, against the regions as a PNG.
Outcome plot(const std::vector<Measurement>& measurements, const std::string& file);

}  // namespace nacre::test
