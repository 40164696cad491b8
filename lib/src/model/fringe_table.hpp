#pragma once

#include <glm/gtc/constants.hpp>

#include <nacre/fringe_table.hpp>

#include "complex.hpp"
#include "material.hpp"

namespace nacre::model {

// The texture's look-up is FringeTable::look, which undoes the texels' coding.

inline dvec3 firstFringe(const FringeTable& table, dvec3 path)
{
    return {table.look(path.x, 0.0).x, table.look(path.y, 0.0).y, table.look(path.z, 0.0).z};
}

inline dvec3 fringeOfPhase(const FringeTable& table, double path, Complex ratio, double angle, double steps, double pathPerRadian)
{
    constexpr double phases = FringeTable::phases;
    const double moved = path + (angle - steps * (glm::pi<double>() / phases)) * pathPerRadian;
    steps = moved < 0.0 ? -steps : steps;
    const double turn = std::floor(steps / phases);
    const double size = turn == 0.0 || turn == -2.0 ? std::abs(ratio) : -std::abs(ratio);
    return size * table.look(std::fabs(moved), size, static_cast<int>(steps - turn * phases));
}

inline dvec3 fringeOfRatio(const FringeTable& table, double path, Complex ratio, double pathPerRadian)
{
    constexpr double phases = FringeTable::phases;
    const double angle = ratio == 0.0 ? 0.0 : std::arg(ratio);
    const double steps = std::floor(angle * (phases / glm::pi<double>()));
    const double share = angle * (phases / glm::pi<double>()) - steps;
    return (1.0 - share) * fringeOfPhase(table, path, ratio, angle, steps, pathPerRadian) +
           share * fringeOfPhase(table, path, ratio, angle, steps + 1.0, pathPerRadian);
}

}  // namespace nacre::model
