#include "slider_span.hpp"

#include <array>

namespace nacre::demo {
namespace {

struct Named {
    std::string_view name;
    SliderSpan span;
};

// Those whose declared range is wider than what is seen, and why they end where they do.
constexpr std::array<Named, 13> usual{{
    {"ior", {1.0, 3.0, false}},                       // air to a semiconductor's oxide
    {"iorOutside", {1.0, 2.0, false}},
    {"wavelengthNm", {380.0, 780.0, false}},          // what the eye sees
    {"thicknessLeastNm", {0.0, 1000.0, false}},       // the orders that have colours
    {"thicknessMostNm", {0.0, 1000.0, false}},
    {"noiseFrequency", {0.1, 100.0, true}},
    {"noiseSeed", {0.0, 100.0, false}},
    {"upperExponent", {1.0, 10000.0, true}},          // matt to a mirror with a soft edge
    {"lowerExponent", {1.0, 10000.0, true}},
    {"specularWeight", {0.0, 4.0, false}},
    {"diffuseWeight", {0.0, 4.0, false}},
    {"substrateIndex", {0.05, 5.0, true}},            // silver's n to silicon's
    {"substrateAbsorption", {0.0, 10.0, false}},      // aluminium's is 7
}};

}  // namespace

SliderSpan sliderSpan(const Parameter& parameter)
{
    for (const Named& named : usual) {
        if (named.name == parameter.name) return named.span;
    }
    return {parameter.least, parameter.most, parameter.most >= 1000.0};
}

}  // namespace nacre::demo
