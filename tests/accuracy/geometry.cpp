#include "geometry.hpp"

#include "model/direction.hpp"

namespace nacre::test {

glm::dvec3 Frame::at(double cosTheta, double azimuth) const
{
    const double sinTheta = std::sqrt(std::fmax(0.0, (1.0 - cosTheta) * (1.0 + cosTheta)));
    return (x * std::cos(azimuth) + y * std::sin(azimuth)) * sinTheta + z * cosTheta;
}

glm::dvec3 randomDirection(Random& random)
{
    const double cosTheta = random.uniform(-1.0, 1.0);
    return Frame{}.at(cosTheta, random.uniform(0.0, glm::two_pi<double>()));
}

Frame randomFrame(Random& random)
{
    Frame frame;
    if (random.chance(0.5)) return frame;
    frame.z = randomDirection(random);
    model::frame(frame.z, frame.x, frame.y);
    return frame;
}

glm::dvec3 turned(Random& random, glm::dvec3 axis, double angle)
{
    Frame frame;
    frame.z = axis;
    model::frame(frame.z, frame.x, frame.y);
    const double azimuth = random.uniform(0.0, glm::two_pi<double>());
    return axis * std::cos(angle) + (frame.x * std::cos(azimuth) + frame.y * std::sin(azimuth)) * std::sin(angle);
}

glm::dvec3 mirrored(glm::dvec3 l, glm::dvec3 normal)
{
    return 2.0 * dot(normal, l) * normal - l;
}

}  // namespace nacre::test
