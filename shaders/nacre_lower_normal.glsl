#ifndef NACRE_LOWER_NORMAL_GLSL
#define NACRE_LOWER_NORMAL_GLSL

// The normal of the lower boundary [n1]: Granier & Heidrich 2003, Sec 3.2 and 6.2.
// All results are unit vectors where upperNormal is one.

#if NACRE_LOWER_NORMAL != NACRE_LOWER_NORMAL_PARALLEL

// Sec 6.2, Figure 3: turned away from the upper normal by one angle everywhere, towards the tangent
// turned by the azimuth. handedness: +1 or -1, the tangent.w of glTF.
vec3 nacre_lowerNormalConstant(nacre_Material m, vec3 upperNormal, vec3 tangent, float handedness)
{
    vec3 x, y;
    nacre_frame(upperNormal, x, y);
    vec3 along = nacre_direction(tangent - upperNormal * dot(upperNormal, tangent));
    along = dot(along, along) > 0.0 ? along : x;
    vec3 across = cross(upperNormal, along) * handedness;
    return upperNormal * m.deviationCos + (along * m.azimuthCos + across * m.azimuthSin) * m.deviationSin;
}

// Sec 6.3, Figure 4, after Blinn 1978: the lower boundary lies the layer's thickness below the upper
// one, so its normal leans along the gradient of the thickness. A gradient of one per feature leans
// by the deviation, in the direction of the gradient turned by the azimuth.
// gradient: in the space of the normal (an object's gradient is carried there by the matrix that
// carries its normals); its part along the normal is taken off.
vec3 nacre_lowerNormalGradient(nacre_Material m, vec3 upperNormal, vec3 gradient)
{
    vec3 along = gradient - upperNormal * dot(upperNormal, gradient);
    vec3 across = cross(upperNormal, along);
    return nacre_direction(upperNormal * m.deviationCos + (along * m.azimuthCos + across * m.azimuthSin) * m.deviationSin);
}

#if NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_INDEPENDENT || NACRE_LOWER_NORMAL == NACRE_LOWER_NORMAL_ANY
// Sec 3.2: independent of the thickness: the same lean along the gradient of noise of its own. The
// seed is moved far beyond the octaves that the thickness uses.
vec3 nacre_independentGradient(nacre_Material m, vec3 p)
{
    return nacre_turbulence(p * m.noiseFrequency, m.noiseOctaves, m.noiseSeed + 7919).xyz;
}
#endif

#endif

#endif
