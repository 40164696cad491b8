#ifndef NACRE_SURFACE_GLSL
#define NACRE_SURFACE_GLSL

#if NACRE_THICKNESS != NACRE_THICKNESS_MAP

// The local configuration of a point from the material alone: thickness and both normals.
// Granier & Heidrich 2003, Sec 3.2. A host with maps of its own fills nacre_Surface itself.
//   upperNormal       shading normal, any length but 0
//   tangent           xyz in the space of the normal, w the handedness, as in glTF
//   objectPosition    the point in the object's own space, where the noise lives
//   normalToShading   carries the object's normals to the space of upperNormal
// Parallel boundaries pass the normal on as it is; nacre_view makes it a unit vector.
nacre_Surface nacre_surface(nacre_Material m, vec3 upperNormal, vec4 tangent, vec3 objectPosition, mat3 normalToShading)
{
    nacre_Surface s = nacre_Surface(upperNormal, upperNormal, 0.0);
    vec3 gradient = vec3(0.0);
#if NACRE_THICKNESS == NACRE_THICKNESS_NOISE
    vec4 thickness = nacre_thickness(m, objectPosition);
    s.thicknessUm = thickness.w;
    gradient = thickness.xyz;
#endif
#if NACRE_LOWER_NORMAL != NACRE_LOWER_NORMAL_PARALLEL
    s.upperNormal = nacre_direction(upperNormal);
    s.lowerNormal = s.upperNormal;
#endif
#if NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_CONSTANT
    s.lowerNormal = nacre_lowerNormalConstant(m, s.upperNormal, tangent.xyz, tangent.w);
#elif NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_INDEPENDENT
    s.lowerNormal = nacre_lowerNormalGradient(m, s.upperNormal, normalToShading * nacre_independentGradient(m, objectPosition));
#elif NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_GRADIENT
    s.lowerNormal = nacre_lowerNormalGradient(m, s.upperNormal, normalToShading * gradient);
#elif NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_ANY
    if (m.lowerNormal == NACRE_LOWER_NORMAL_CONSTANT) {
        s.lowerNormal = nacre_lowerNormalConstant(m, s.upperNormal, tangent.xyz, tangent.w);
    } else if (m.lowerNormal != NACRE_LOWER_NORMAL_PARALLEL) {
        if (m.lowerNormal == NACRE_LOWER_NORMAL_INDEPENDENT) gradient = nacre_independentGradient(m, objectPosition);
        s.lowerNormal = nacre_lowerNormalGradient(m, s.upperNormal, normalToShading * gradient);
    }
#endif
    return s;
}

#endif

#endif
