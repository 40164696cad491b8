#pragma once

#include <string>
#include <vector>

#include <nacre/result.hpp>

namespace nacre::test {

/// One stable form of the GLSL, and the naive one that could stand in its place: to measure what each costs
/// and what it buys. The library itself ships the stable ones only.
struct NaiveForm {
    std::string name;
    std::string instead;  ///< What the naive form does, in words.
    std::string text;     ///< GLSL: the naive function, and a #define that puts it in place.
    bool isSwitch;        ///< The text goes before the library: a switch of nacre_config.glsl.
};

const std::vector<NaiveForm>& naiveForms();

/// The library's text with a form made naive. The error lists the names.
Result<std::string> withNaiveForm(const std::string& library, const std::string& name);

}  // namespace nacre::test
