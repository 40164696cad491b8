#ifndef NACRE_DIRECTION_GLSL
#define NACRE_DIRECTION_GLSL

// The unit vector along a, or the zero vector where a has no direction (zero, infinite, NaN).
// Scaled by its largest component first, so that its square neither overflows nor underflows.
// The test is one that NaN fails: max() may hide a NaN, the sum of squares does not.
// A vector whose squared length is 1 but for the rounding of its components and of the sum (four units in
// the last place, 4.8e-7) is returned as it is: dividing it once more would only round its direction.
// Without NACRE_STABLE_LOBES vectors of a length within 1e-19 and 1e19 have a direction.
vec3 nacre_direction(vec3 a)
{
#if NACRE_STABLE_LOBES
    if (abs(dot(a, a) - 1.0) <= 4.8e-7) return a;
    float largest = max(max(abs(a.x), abs(a.y)), abs(a.z));
    vec3 scaled = a / largest;
    float squared = dot(scaled, scaled);
    return squared >= 1.0 && squared <= 3.0 ? scaled * (1.0 / sqrt(squared)) : vec3(0.0);
#else
    float squared = dot(a, a);
    return squared > 0.0 && squared < 3e38 ? a * inversesqrt(squared) : vec3(0.0);
#endif
}

#if NACRE_TILT || NACRE_LOWER_NORMAL != NACRE_LOWER_NORMAL_PARALLEL

// Two unit vectors that complete the unit vector n to a right-handed frame (x, y, n).
// Duff et al. 2017, "Building an orthonormal basis, revisited": no direction of n is singular.
void nacre_frame(vec3 n, out vec3 x, out vec3 y)
{
    float side = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + n.z);
    float b = n.x * n.y * a;
    x = vec3(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
    y = vec3(b, side + n.y * n.y * a, -n.y);
}

#endif

#endif
