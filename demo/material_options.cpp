#include "material_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <nacre/validate.hpp>

#include "numbers.hpp"

namespace nacre::demo {
namespace {

std::vector<Parameter> sharing(const std::string& option)
{
    std::vector<Parameter> found;
    for (const Parameter& parameter : parameters()) {
        if (parameter.option == option) found.push_back(parameter);
    }
    return found;
}

std::vector<std::string> options()
{
    std::vector<std::string> names;
    for (const Parameter& parameter : parameters()) {
        const std::string name(parameter.option);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

bool isRange(const std::string& option)
{
    return option == "--thickness";
}

// Where the numbers of an option live in a material, in the order in which they are given.
std::vector<double*> places(Material& material, const std::string& option)
{
    std::vector<double*> all;
    for (const Parameter& parameter : sharing(option)) {
        if (const auto* real = std::get_if<double Material::*>(&parameter.member)) all.push_back(&(material.**real));
        if (const auto* rgb = std::get_if<glm::dvec3 Material::*>(&parameter.member)) {
            for (int channel = 0; channel < 3; ++channel) all.push_back(&(material.**rgb)[channel]);
        }
    }
    return all;
}

// All values of an option as the command line takes them: `90,170`, `66..76`.
std::string valuesText(const Material& material, const std::string& option)
{
    std::string text;
    for (const Parameter& parameter : sharing(option)) {
        text += (text.empty() ? "" : isRange(option) ? ".." : ",") + valueText(material, parameter);
    }
    return text;
}

// `A,B,C`, `A..B`: what the option's value looks like.
std::string shape(const std::string& option)
{
    Material any;
    if (isRange(option)) return "A..B";
    const std::size_t count = places(any, option).size();
    return count == 3 ? "R,G,B" : count == 2 ? "UPPER,LOWER" : "N";
}

Outcome applyChoice(Material& material, const Parameter& parameter, const std::string& text)
{
    const auto& names = choices(parameter);
    const auto at = std::find(names.begin(), names.end(), text);
    if (at == names.end()) {
        std::string known;
        for (std::string_view name : names) known += (known.empty() ? "" : ", ") + std::string(name);
        return Error{std::string(parameter.option) + ": expected one of " + known + ", got '" + text + "'"};
    }
    setChoice(material, parameter, static_cast<int>(at - names.begin()));
    return std::monostate{};
}

Outcome applyWhole(Material& material, const Parameter& parameter, int Material::*member, const std::string& text)
{
    double value = 0.0;
    if (!parseNumber(text, value) || value != std::floor(value) || !(value >= parameter.least && value <= parameter.most)) {
        std::ostringstream range;
        range << std::string(parameter.option) << ": expected a whole number from " << parameter.least << " to " << parameter.most
              << ", got '" << text << "'";
        return Error{range.str()};
    }
    material.*member = static_cast<int>(value);
    return std::monostate{};
}

// A single number stands for all of them: `--ior 1.5`.
Outcome applyNumbers(Material& material, const std::string& option, const std::string& text)
{
    const std::vector<double*> targets = places(material, option);
    const std::vector<std::string> parts = split(text, isRange(option) ? ".." : ",");
    std::vector<double> values(parts.size());
    bool fits = parts.size() == 1 || parts.size() == targets.size();
    for (std::size_t i = 0; i < parts.size(); ++i) fits = parseNumber(parts[i], values[i]) && fits;
    if (!fits) return Error{option + ": expected " + (targets.size() > 1 ? "N or " : "") + shape(option) + " in numbers, got '" + text + "'"};
    for (std::size_t i = 0; i < targets.size(); ++i) *targets[i] = values.size() == 1 ? values.front() : values[i];
    return std::monostate{};
}

}  // namespace

void MaterialOptions::addTo(CLI::App& app)
{
    for (const std::string& option : options()) {
        std::ostringstream help;
        for (const Parameter& parameter : sharing(option)) help << (help.tellp() > 0 ? " " : "") << parameter.effect;
        const Parameter first = sharing(option).front();
        std::string form = shape(option);
        if (!choices(first).empty()) {
            form.clear();
            for (std::string_view name : choices(first)) form += (form.empty() ? "" : "|") + std::string(name);
        }
        help << " [default " << valuesText(Material{}, option) << "; " << (first.unit.empty() ? "" : std::string(first.unit) + ", ") << first.least << " to " << first.most << "]";
        app.add_option_function<std::string>(option, [this, option](const std::string& text) { given_[option] = text; }, help.str())
            ->type_name(form)
            ->group("Material");
    }
}

Result<Material> MaterialOptions::apply(Material material) const
{
    for (const auto& [option, text] : given_) {
        const Parameter first = sharing(option).front();
        Outcome outcome = std::monostate{};
        if (!choices(first).empty()) {
            outcome = applyChoice(material, first, text);
        } else if (const auto* whole = std::get_if<int Material::*>(&first.member)) {
            outcome = applyWhole(material, first, *whole, text);
        } else {
            outcome = applyNumbers(material, option, text);
        }
        if (!outcome) return outcome.error();
    }
    const bool isTilted = given_.count("--deviation") != 0 && given_.count("--lower-normal") == 0;
    if (isTilted && material.lowerNormal == LowerNormal::parallel) material.lowerNormal = LowerNormal::constant;

    const std::vector<Fault> faults = validate(material);
    if (faults.empty()) return material;
    const std::string member = faults.front().field.substr(0, faults.front().field.find('.'));
    const auto& table = parameters();
    const auto parameter = std::find_if(table.begin(), table.end(), [&](const Parameter& p) { return p.name == member; });
    return Error{std::string(parameter->option) + ": " + faults.front().message};
}

std::string optionsText(const Material& material, const Material& base)
{
    std::string text;
    for (const std::string& option : options()) {
        const std::string value = valuesText(material, option);
        // Said where apply() would otherwise tilt the boundaries for the deviation's sake.
        const bool isMeant = option == "--lower-normal" && material.lowerNormal == LowerNormal::parallel &&
                             material.deviationDegrees != base.deviationDegrees;
        if (isMeant || value != valuesText(base, option)) text += ' ' + option + '=' + value;
    }
    return text;
}

std::string valueText(const Material& material, const Parameter& parameter)
{
    if (const auto* real = std::get_if<double Material::*>(&parameter.member)) return numberText(material.**real);
    if (const auto* whole = std::get_if<int Material::*>(&parameter.member)) return std::to_string(material.**whole);
    if (const auto* rgb = std::get_if<glm::dvec3 Material::*>(&parameter.member)) {
        const glm::dvec3& channels = material.**rgb;
        return numberText(channels.r) + ',' + numberText(channels.g) + ',' + numberText(channels.b);
    }
    return std::string(choices(parameter)[static_cast<std::size_t>(choice(material, parameter))]);
}

}  // namespace nacre::demo
