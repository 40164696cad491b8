#ifndef NACRE_PHASE_GLSL
#define NACRE_PHASE_GLSL

// The phase in cycles: Granier & Heidrich 2003, Eq 3, Phi = pi OPD / lambda, OPD = r1 d (cosTi + cosTo).
// highp where the profile is ES: a layer of 10 um is 1e2 cycles, of which the fraction counts.

// r1 d / lambda, the layer's thickness in wavelengths, as head + tail. The head has 12 significant bits, so that
// its product with another such number is exact; without NACRE_SPLIT_PHASE it is all there is.
struct nacre_Path {
    highp vec3 head;
    highp vec3 tail;
};

// The first 12 of a float's 24 significant bits.
highp float nacre_head(highp float a)
{
    return uintBitsToFloat(floatBitsToUint(a) & 0xFFFFF000u);
}

highp vec3 nacre_head(highp vec3 a)
{
    return uintBitsToFloat(floatBitsToUint(a) & uvec3(0xFFFFF000u));
}

// A thickness that is none (negative, NaN, above a metre, where products would overflow before long) counts as 0; the
// comparison is one that NaN fails.
highp float nacre_sound(highp float thicknessUm)
{
    return thicknessUm >= 0.0 && thicknessUm <= 1e6 ? thicknessUm : 0.0;
}

// cyclesPerUm, cyclesPerUmTail: r1 / lambda as the host split it, nacre_Material.
nacre_Path nacre_path(highp vec3 cyclesPerUm, highp vec3 cyclesPerUmTail, highp float thicknessUm)
{
    thicknessUm = nacre_sound(thicknessUm);
#if NACRE_SPLIT_PHASE
    highp float thickness = nacre_head(thicknessUm);
    highp vec3 product = cyclesPerUm * thickness;  // exact
    highp vec3 head = nacre_head(product);
    highp vec3 tail = (product - head) + (cyclesPerUm * (thicknessUm - thickness) + cyclesPerUmTail * thicknessUm);
    return nacre_Path(head, tail);
#else
    return nacre_Path((cyclesPerUm + cyclesPerUmTail) * thicknessUm, vec3(0.0));
#endif
}

// The same from the host's head and tail of it, where the thickness is constant.
nacre_Path nacre_constantPath(highp vec3 head, highp vec3 tail)
{
#if NACRE_SPLIT_PHASE
    return nacre_Path(head, tail);
#else
    return nacre_Path(head + tail, vec3(0.0));
#endif
}

// OPD / lambda with whole cycles left out, between -1 and 1 or a little beyond; the cosine asks for no more.
// cosSum: cosTi + cosTo.
highp vec3 nacre_pathCycles(nacre_Path path, highp nacre_Channels cosSum)
{
#if NACRE_SPLIT_PHASE
    highp nacre_Channels cosHead = nacre_head(cosSum);
    highp vec3 product = path.head * cosHead;  // exact, and so is what is left of it
    return (product - floor(product + 0.5)) + (path.head * (cosSum - cosHead) + path.tail * cosSum);
#else
    return path.head * cosSum;
#endif
}

// cos Phi, but for its sign, of a phase Phi = pi cycles.
// The whole cycles are taken off first: exact, and no driver's own reduction of large arguments
// is asked. Then |cos Phi| = sin(pi y), y = 1/2 - |remainder| in [0, 1/2]: y is exact too, so the dark
// fringe, where y is near 0, keeps its relative precision. sin(pi y) / y is fitted by a polynomial in
// y^2 (minimax on [0, 1/4], residual 6e-9 relative), the same on every driver.
vec3 nacre_cosPhase(highp vec3 cycles)
{
#if NACRE_POLYNOMIAL_COSINE
    highp vec3 y = 0.5 - abs(cycles - floor(cycles + 0.5));
    highp vec3 z = y * y;
    return y * (3.14159265 + z * (-5.16771057 + z * (2.55008231 + z * (-0.598308094 + z * 0.0776759721))));
#else
    return cos(3.14159265 * cycles);
#endif
}

#endif
