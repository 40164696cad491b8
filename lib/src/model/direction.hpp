#pragma once

#include "material.hpp"

namespace nacre::model {

inline dvec3 direction(dvec3 a)
{
    const double largest = std::fmax(std::fmax(std::fabs(a.x), std::fabs(a.y)), std::fabs(a.z));
    const dvec3 scaled = a / largest;
    const double squared = dot(scaled, scaled);
    return squared >= 1.0 && squared <= 3.0 ? scaled / std::sqrt(squared) : dvec3(0.0);
}

inline void frame(dvec3 n, dvec3& x, dvec3& y)
{
    const double side = n.z >= 0.0 ? 1.0 : -1.0;
    const double a = -1.0 / (side + n.z);
    const double b = n.x * n.y * a;
    x = dvec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
    y = dvec3(b, side + n.y * n.y * a, -n.y);
}

}  // namespace nacre::model
