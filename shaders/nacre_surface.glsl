#ifndef NACRE_SURFACE_GLSL
#define NACRE_SURFACE_GLSL

// The local configuration of a point from the material alone: thickness and both normals.
// Granier & Heidrich 2003, Sec 3.2. A host with maps of its own fills nacre_Surface itself.
//   upperNormal       shading normal, any length but 0
//   tangent           xyz in the space of the normal, w the handedness, as in glTF
//   objectPosition    the point in the object's own space, where the noise lives
//   normalToShading   carries the object's normals to the space of upperNormal
nacre_Surface nacre_surface(nacre_Material m, vec3 upperNormal, vec4 tangent, vec3 objectPosition, mat3 normalToShading)
{
    nacre_Surface s;
    s.upperNormal = nacre_direction(upperNormal);
    s.lowerNormal = s.upperNormal;
    vec4 thickness = nacre_thickness(m, objectPosition);
    s.thicknessUm = thickness.w;
    if (m.lowerNormal == NACRE_LOWER_NORMAL_CONSTANT) {
        s.lowerNormal = nacre_lowerNormalConstant(m, s.upperNormal, tangent.xyz, tangent.w);
    } else if (m.lowerNormal == NACRE_LOWER_NORMAL_INDEPENDENT) {
        vec3 gradient = normalToShading * nacre_independentGradient(m, objectPosition);
        s.lowerNormal = nacre_lowerNormalGradient(m, s.upperNormal, gradient);
    } else if (m.lowerNormal == NACRE_LOWER_NORMAL_GRADIENT) {
        s.lowerNormal = nacre_lowerNormalGradient(m, s.upperNormal, normalToShading * thickness.xyz);
    }
    return s;
}

#endif
