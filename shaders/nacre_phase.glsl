#ifndef NACRE_PHASE_GLSL
#define NACRE_PHASE_GLSL

// The path through the layer in wavelengths, OPD / λ = r1 d / λ (cosTi + cosTo).
// Granier & Heidrich 2003, Eq 3, whose Φ is π times this.
vec3 nacre_pathCycles(vec3 cyclesAtNormal, vec3 cosTi, vec3 cosTo)
{
    return cyclesAtNormal * (cosTi + cosTo);
}

// cos Φ, but for its sign, of a phase Φ = π cycles.
// The whole cycles are taken off first: exact, and no driver's own reduction of large arguments
// is asked. Then |cos Φ| = sin(π y), y = 1/2 - |remainder| in [0, 1/2]: y is exact too, so the dark
// fringe, where y is near 0, keeps its relative precision. sin(π y) / y is fitted by a polynomial in
// y² (minimax on [0, 1/4], residual 6e-9 relative), the same on every driver.
vec3 nacre_cosPhase(vec3 cycles)
{
    vec3 y = 0.5 - abs(cycles - floor(cycles + 0.5));
    vec3 z = y * y;
    return y * (3.14159265 + z * (-5.16771057 + z * (2.55008231 + z * (-0.598308094 + z * 0.0776759721))));
}

#endif
