#pragma once

#include <CLI/CLI.hpp>

#include <iostream>
#include <optional>

namespace nacre::demo {

/// Parses the arguments. The exit status where the program is done: 0 after --help, 2 after one line
/// that names a bad option.
inline std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv)
{
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        std::cerr << app.get_name() << ": " << error.what() << "; --help lists the options\n";
        return 2;
    }
    return std::nullopt;
}

}  // namespace nacre::demo
