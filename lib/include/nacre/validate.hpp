#pragma once

#include <string>
#include <vector>

#include <nacre/material.hpp>

namespace nacre {

/// One thing that is wrong with a material.
struct Fault {
    std::string field;    ///< Member of Material, with the channel where it has some: `ior.g`.
    std::string value;    ///< What it holds.
    std::string message;  ///< `expected 0.1 <= ior.g <= 10, got -1`.
};

/// Every fault of a material in the order of `parameters()`; empty: it is valid.
std::vector<Fault> validate(const Material& material);

}  // namespace nacre
