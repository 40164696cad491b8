#pragma once

#include <map>
#include <string>
#include <vector>

#include <nacre/material.hpp>
#include <nacre/parameters.hpp>
#include <nacre/result.hpp>

namespace CLI {
class App;
}

namespace nacre::demo {

/// Command-line options for a material, made from nacre::parameters(): parameters that share an
/// option are given together, `--exponents 90,170`; a range as `--thickness 66..76`.
class MaterialOptions {
public:
    /// Adds the options to app, which parses into this object and must not outlive it.
    void addTo(CLI::App& app);

    /// The base with what the command line gave put over it. The error names the option.
    /// A deviation without --lower-normal turns parallel boundaries into a constant deviation.
    Result<Material> apply(Material base) const;

    /// Whether the command line gave any of them.
    bool areGiven() const { return !given_.empty(); }

private:
    std::map<std::string, std::string> given_;
};

/// The options that turn base into material, in the order of parameters(): ` --ior=1.4,1.45,1.6 --deviation=8`.
/// What an option takes together is said together; values are short, nine digits.
std::string optionsText(const Material& material, const Material& base);

/// A member's value as the options take it: `1.4,1.45,1.6`.
std::string valueText(const Material& material, const Parameter& parameter);

}  // namespace nacre::demo
