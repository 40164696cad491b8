#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <nacre/fringe_table.hpp>
#include <nacre/material.hpp>
#include <nacre/result.hpp>

namespace nacre {

/// The layer at a point: the local configuration of Sec 3.2, Figure 1. All vectors of one evaluation are
/// in one common space and point away from the surface.
struct Surface {
    glm::dvec3 upperNormal{0.0, 0.0, 1.0};  ///< [n0]; any length, but it needs a direction.
    glm::dvec3 lowerNormal{0.0, 0.0, 1.0};  ///< [n1]; likewise.
    double thicknessNm = 0.0;               ///< [d], >= 0
};

/// The terms of the model for one light and one viewer, per channel.
struct Evaluation {
    glm::dvec3 rho;      ///< Specular BRDF [ρ, Eq 5], 1/sr without the cosine.
    glm::dvec3 R;        ///< Reflected at the upper boundary [Eq 6].
    glm::dvec3 T;        ///< Through the layer and back [Eq 10]; physical: after all internal bounces.
    glm::dvec3 phi;      ///< Phase [Φ, Eq 3], radians; 0 where light or viewer have no ray in the layer.
    glm::dvec3 diffuse;  ///< Diffuse coefficient [ρd, Eq 16]; physical: diffuse BRDF, 1/sr.
    glm::dvec3 meanCos;  ///< Mean cosine inside the layer [Eq 14]; NaN where the layer's index is below the outside's.
    glm::dvec3 shaded;   ///< Both parts weighted, times the cosine of the light (Sec 6).
};

/// What the shaders compute, in double precision: `nacre_surface`.
///   normal           any length, but it needs a direction
///   tangent          xyz in the space of the normal, w its handedness, +1 or -1, as in glTF
///   objectPosition   where the noise is looked up
///   normalToShading  carries the object's normals to the space of `normal`
Result<Surface> surface(const Material& material, glm::dvec3 normal, glm::dvec4 tangent, glm::dvec3 objectPosition,
                        const glm::dmat3& normalToShading = glm::dmat3(1.0));

/// What the shaders compute for the material's quality, in double precision: `nacre_view`, `nacre_terms`,
/// `nacre_light`, or `nacre_physicalView` and so on, with the fringe table where there is one. The
/// thickness is the surface's, not the material's. light and view are unit vectors; below the surface,
/// or with a normal that has no direction, the terms are 0. An invalid material is an error, and so is
/// a surface, light or view that is not finite.
Result<Evaluation> evaluate(const Material& material, const Surface& surface, glm::dvec3 light, glm::dvec3 view,
                            const FringeTable* fringeTable = nullptr);

}  // namespace nacre
