// The README's table of parameters is the library's own.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include <nacre/parameters.hpp>

#include "material_options.hpp"
#include "view/keys.hpp"

namespace {

using namespace nacre;

std::string row(const Parameter& parameter)
{
    const std::string option(parameter.option);
    std::ostringstream line;
    line << "| `" << parameter.name << "` | " << parameter.symbol << " | " << parameter.unit << " | ";
    if (const auto& names = choices(parameter); !names.empty()) {
        for (std::size_t i = 0; i < names.size(); ++i) line << (i ? ", " : "") << names[i];
    } else {
        line << parameter.least << " to " << parameter.most;
    }
    line << " | " << demo::valueText(Material{}, parameter) << " | `" << option << "` | " << parameter.effect << " |";
    return line.str();
}

TEST(Readme, ListsTheParametersAsTheyAreDeclared)
{
    std::ifstream file(NACRE_README);
    const std::string readme((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::string table;
    for (const Parameter& parameter : parameters()) table += row(parameter) + '\n';
    EXPECT_TRUE(readme.find(table) != std::string::npos) << "expected in the README:\n" << table;
}

TEST(Readme, ListsTheViewersKeysAsItObeysThem)
{
    std::ifstream file(NACRE_README);
    const std::string readme((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const auto table = [](const auto& bindings) {
        std::string rows;
        for (const auto& binding : bindings) rows += std::string("| ") + binding.label + " | " + binding.effect + " |\n";
        return rows;
    };
    for (const std::string& rows : {table(demo::keyBindings()), table(demo::mouseBindings())}) {
        EXPECT_TRUE(readme.find(rows) != std::string::npos) << "expected in the README:\n" << rows;
    }
}

}  // namespace
