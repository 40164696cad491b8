#ifndef NACRE_CONFIG_GLSL
#define NACRE_CONFIG_GLSL

// Every compile-time switch and its default; define one before this file to change it.

// Most octaves of noise, the bound of a loop. The host's range for noiseOctaves ends here too.
#ifndef NACRE_MAX_OCTAVES
#define NACRE_MAX_OCTAVES 8
#endif

// 1: the path through the layer is multiplied out in two parts, so that a thick layer's phase is not
// lost in the rounding of its whole cycles. 0: in one, which below 10 µm is as good and cheaper.
#ifndef NACRE_SPLIT_PHASE
#define NACRE_SPLIT_PHASE 1
#endif

// nacre::LowerNormal
#define NACRE_LOWER_NORMAL_PARALLEL 0
#define NACRE_LOWER_NORMAL_CONSTANT 1
#define NACRE_LOWER_NORMAL_INDEPENDENT 2
#define NACRE_LOWER_NORMAL_GRADIENT 3

#endif
