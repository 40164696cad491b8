#include "viewpoint_options.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <charconv>
#include <vector>

#include "numbers.hpp"

namespace nacre::demo {
namespace {

struct Number {
    float* place;
    double least, most;
};

struct Option {
    const char* name;
    const char* shape;
    const char* help;
    std::vector<Number> numbers;
};

// The options of a viewpoint and where their numbers live in it.
std::vector<Option> options(Viewpoint& v)
{
    constexpr double any = 1e6;  // scene radii, or a direction's part: no picture needs more
    return {{"--orbit", "AZIMUTH,ELEVATION", "Degrees around the scene: to the right of its front, above the horizon [default 20,15]",
             {{&v.azimuthDegrees, -360.0, 360.0}, {&v.elevationDegrees, -89.0, 89.0}}},
            {"--zoom", "N", "How much nearer than the distance that frames the scene [default 1]", {{&v.zoom, 0.01, 1000.0}}},
            {"--target", "X,Y,Z", "What the camera looks at and turns about, from the scene's middle, in its radii [default 0,0,0]",
             {{&v.target.x, -any, any}, {&v.target.y, -any, any}, {&v.target.z, -any, any}}},
            {"--light", "X,Y,Z", "Direction to the key light along the camera's axes: right, up, to the viewer [default -0.45,0.65,0.75]",
             {{&v.light.x, -any, any}, {&v.light.y, -any, any}, {&v.light.z, -any, any}}}};
}

// The shortest digits that give the floats back.
std::string valueText(const Option& option)
{
    std::string text;
    for (const Number& number : option.numbers) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *number.place).ptr;
        text += (text.empty() ? "" : ",") + std::string(digits.data(), end);
    }
    return text;
}

Outcome read(const Option& option, const std::string& text)
{
    const std::vector<std::string> parts = split(text, ",");
    const std::string expected = std::string(option.name) + ": expected " + option.shape + " in numbers";
    if (parts.size() != option.numbers.size()) return Error{expected + ", got '" + text + "'"};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Number& number = option.numbers[i];
        double value = 0.0;
        if (!parseNumber(parts[i], value)) return Error{expected + ", got '" + text + "'"};
        if (!(value >= number.least && value <= number.most)) {
            return Error{expected + " from " + numberText(number.least) + " to " + numberText(number.most) + ", got " + parts[i]};
        }
        *number.place = static_cast<float>(value);
    }
    return std::monostate{};
}

}  // namespace

void ViewpointOptions::addTo(CLI::App& app)
{
    Viewpoint any;
    for (const Option& option : options(any)) {
        const std::string name = option.name;
        app.add_option_function<std::string>(name, [this, name](const std::string& text) { given_[name] = text; }, option.help)
            ->type_name(option.shape)
            ->group("View");
    }
}

Result<Viewpoint> ViewpointOptions::viewpoint() const
{
    Viewpoint viewpoint;
    for (const Option& option : options(viewpoint)) {
        const auto given = given_.find(option.name);
        if (given == given_.end()) continue;
        if (Outcome outcome = read(option, given->second); !outcome) return outcome.error();
    }
    const glm::vec3 light = viewpoint.light;
    if (light == glm::vec3(0.0F)) return Error{"--light: expected a direction, got 0,0,0"};
    return viewpoint;
}

std::string optionsText(const Viewpoint& viewpoint)
{
    Viewpoint given = viewpoint, usual;
    const std::vector<Option> table = options(given), defaults = options(usual);
    std::string text;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const std::string value = valueText(table[i]);
        // With `=`, since a value may begin with a minus.
        if (value != valueText(defaults[i])) text += std::string(" ") + table[i].name + '=' + value;
    }
    return text;
}

}  // namespace nacre::demo
