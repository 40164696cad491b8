#include "snippet.hpp"

#include <nacre/parameters.hpp>

#include "material_options.hpp"
#include "models.hpp"
#include "numbers.hpp"
#include "viewpoint_options.hpp"

namespace nacre::demo {
namespace {

// `nacre::LowerNormal::`: the type that a choice's names belong to.
std::string enumeration(const Parameter& parameter)
{
    if (std::holds_alternative<LowerNormal Material::*>(parameter.member)) return "nacre::LowerNormal::";
    if (std::holds_alternative<Quality Material::*>(parameter.member)) return "nacre::Quality::";
    if (std::holds_alternative<Substrate Material::*>(parameter.member)) return "nacre::Substrate::";
    return "nacre::Lobes::";
}

std::string spaced(const std::string& numbers)
{
    std::string text;
    for (const std::string& number : split(numbers, ",")) text += (text.empty() ? "" : ", ") + number;
    return text;
}

// Between single quotes, as a shell reads every character, with the quotes themselves set apart.
std::string quoted(const std::string& text)
{
    const bool isPlain = !text.empty() && text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._/-+,=:@%") == std::string::npos;
    if (isPlain) return text;
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

}  // namespace

std::string snippet(const Look& look)
{
    const Material base = baseOf(look.preset);
    std::string code = "#include <nacre/nacre.hpp>\n\n";
    code += look.preset.empty() ? "nacre::Material material;\n" : "auto material = *nacre::preset(\"" + look.preset + "\");\n";
    for (const Parameter& parameter : parameters()) {
        const std::string value = valueText(look.material, parameter);
        if (value == valueText(base, parameter)) continue;
        code += "material." + std::string(parameter.name) + " = ";
        if (!choices(parameter).empty()) code += enumeration(parameter) + value;
        else if (std::holds_alternative<glm::dvec3 Material::*>(parameter.member)) code += '{' + spaced(value) + '}';
        else code += value;
        code += ";\n";
    }
    return code;
}

std::string renderCommand(const State& state)
{
    const Look& look = state.look();
    std::string command = "nacre-render";
    if (state.model != shippedModel()) command += ' ' + quoted(state.model.string());
    if (!look.preset.empty()) command += " --preset=" + look.preset;
    command += optionsText(look.material, baseOf(look.preset)) + optionsText(state.viewpoint);
    return command + " --size=" + state.pictureSize + " --out=" + quoted(state.pictureFile);
}

}  // namespace nacre::demo
