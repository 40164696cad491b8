#pragma once

#include <array>
#include <map>
#include <string>

#include <nacre/result.hpp>

#include "render/viewpoint.hpp"

namespace CLI {
class App;
}

namespace nacre::demo {

/// Command-line options for a viewpoint: --orbit, --zoom, --target, --light.
class ViewpointOptions {
public:
    /// Adds the options to app, which parses into this object and must not outlive it.
    void addTo(CLI::App& app);

    /// The default viewpoint with what the command line gave put over it. The error names the option.
    Result<Viewpoint> viewpoint() const;

private:
    std::map<std::string, std::string> given_;
};

/// The options that give this viewpoint, in their order; nothing for the default: ` --orbit=30,10 --zoom=2`.
std::string optionsText(const Viewpoint& viewpoint);

}  // namespace nacre::demo
