#include "form_errors.hpp"

#include <nacre/features.hpp>

#include "form_bounds.hpp"
#include "measure.hpp"

namespace nacre::test {
namespace {

Features paperWith(bool Features::*form)
{
    Features features;
    features.physical = false;
    features.*form = false;
    return features;
}

}  // namespace

Result<std::vector<FormError>> measureForms(const demo::Context& context, std::size_t cases, std::uint64_t seed)
{
    std::vector<FormError> errors;
    const auto measure = [&](const char* form, const char* unit, bool Features::*feature, double from, const bounds::Bound& bound, const Region& region) -> Outcome {
        Result<Measurement> measured = measureRegion(context, region, cases, seed, {"", paperWith(feature), false});
        if (!measured) return measured.error();
        errors.push_back({form, unit, from, bound.upTo, measured->spread.worst, bound.error});
        return std::monostate{};
    };
    Outcome outcome = std::monostate{};
    double from = bounds::leastPlainExponent;
    for (const bounds::Bound& bound : bounds::builtInLobes) {
        if (outcome) outcome = measure("built-in lobes", "exponent", &Features::stableLobes, from, bound, formRegion(from, bound.upTo, 0.0, 3.0));
        from = bound.upTo;
    }
    from = 0.0;
    for (const bounds::Bound& bound : bounds::wholePhase) {
        if (outcome) outcome = measure("whole phase", "cycles", &Features::splitPhase, from, bound, formRegion(2.0, 200.0, from, bound.upTo));
        from = bound.upTo;
    }
    from = 0.0;
    for (const bounds::Bound& bound : bounds::builtInCosine) {
        if (outcome) outcome = measure("built-in cosine", "cycles", &Features::polynomialCosine, from, bound, formRegion(2.0, 200.0, from, bound.upTo));
        from = bound.upTo;
    }
    if (!outcome) return outcome.error();
    return errors;
}

}  // namespace nacre::test
