#pragma once

#include "inputs.hpp"
#include "random.hpp"

namespace nacre::test {

/// Any material, or one at a branch of the model: index equal to the outside's or next to it, exponents at the
/// ends of their range, the ends of the spectrum. The rest of the input is left as it is.
void setMaterial(Random& random, Input& input);

/// A thickness, directions and normals for that material: anything, or bit patterns at and around a branch.
void setPoint(Random& random, Input& input);

/// A normal without a direction: zero, infinite, NaN.
bool lacksDirection(glm::vec3 normal);

/// A normal whose components are below the smallest normal float: GLSL leaves open whether they count as 0.
bool isDenormal(glm::vec3 normal);

}  // namespace nacre::test
