#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "random.hpp"

namespace nacre::test {

/// A right-handed frame whose z is the upper normal.
struct Frame {
    glm::dvec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};

    /// The unit vector at that cosine to z and that azimuth from x.
    glm::dvec3 at(double cosTheta, double azimuth) const;
};

glm::dvec3 randomDirection(Random& random);

/// Half of the time the standard frame, in which cosines are as exact as float32 allows; else a random one.
Frame randomFrame(Random& random);

/// A unit vector at `angle` from the unit vector `axis`, at a random azimuth.
glm::dvec3 turned(Random& random, glm::dvec3 axis, double angle);

/// The mirror direction of l, both away from the surface.
glm::dvec3 mirrored(glm::dvec3 l, glm::dvec3 normal);

}  // namespace nacre::test
