#ifndef NACRE_CONFIG_GLSL
#define NACRE_CONFIG_GLSL

// Every compile-time switch and its default, all of the model in its most accurate forms; define one before
// this file to change it. On the host nacre::featuresOf finds the fewest that a material needs, and
// nacre::glsl defines them.

// Qualities that the shader serves. With both, the material's own decides at run time.
#ifndef NACRE_PAPER
#define NACRE_PAPER 1
#endif
#ifndef NACRE_PHYSICAL
#define NACRE_PHYSICAL 1
#endif

// Parts of the material.
#ifndef NACRE_SPECULAR
#define NACRE_SPECULAR 1
#endif
#ifndef NACRE_DIFFUSE
#define NACRE_DIFFUSE 1
#endif

// 0: one index of the layer for all channels, the red one's; what follows from it is a float (nacre_channels.glsl).
#ifndef NACRE_DISPERSION
#define NACRE_DISPERSION 1
#endif

// 0: the boundaries are parallel, whatever the lower normal says.
#ifndef NACRE_TILT
#define NACRE_TILT 1
#endif

// 0: no index of the layer is below the outside's, so nothing is reflected totally.
#ifndef NACRE_TOTAL_REFLECTION
#define NACRE_TOTAL_REFLECTION 1
#endif

// Where the thickness comes from. Constant: all that follows from it is a uniform. Map: the host fills
// nacre_Surface itself and calls no nacre_surface.
#define NACRE_THICKNESS_CONSTANT 0
#define NACRE_THICKNESS_NOISE 1
#define NACRE_THICKNESS_MAP 2
#ifndef NACRE_THICKNESS
#define NACRE_THICKNESS NACRE_THICKNESS_NOISE
#endif

// How nacre_surface finds the lower normal: nacre::LowerNormal, or the material's own at run time.
#define NACRE_LOWER_NORMAL_PARALLEL 0
#define NACRE_LOWER_NORMAL_CONSTANT 1
#define NACRE_LOWER_NORMAL_INDEPENDENT 2
#define NACRE_LOWER_NORMAL_GRADIENT 3
#define NACRE_LOWER_NORMAL_ANY 4
#ifndef NACRE_LOWER_NORMAL
#define NACRE_LOWER_NORMAL NACRE_LOWER_NORMAL_ANY
#endif

// Most octaves of noise, the bound of a loop. The host's range for noiseOctaves ends here too.
#ifndef NACRE_MAX_OCTAVES
#define NACRE_MAX_OCTAVES 8
#endif

// Quality `physical`. 0: what lies below is the same in all channels (with one index of the layer alone).
#ifndef NACRE_SUBSTRATE_CHANNELS
#define NACRE_SUBSTRATE_CHANNELS 1
#endif

// Quality `physical`. 0: what lies below is a dielectric or an F0 colour, never a metal.
#ifndef NACRE_METAL
#define NACRE_METAL 1
#endif

// Quality `physical`. 0: the lobes are never normalised.
#ifndef NACRE_NORMALISED
#define NACRE_NORMALISED 1
#endif

// Quality `physical`: the forms of its fringes that the shader has, from a texture or without one.
#ifndef NACRE_FRINGE_TABLE
#define NACRE_FRINGE_TABLE 1
#endif
#ifndef NACRE_SAMPLER_FREE
#define NACRE_SAMPLER_FREE 1
#endif

// Without the table: harmonics of the fringes that are summed one by one; a closed form follows for the
// rest. At least 1.
#ifndef NACRE_ORDERS
#define NACRE_ORDERS 2
#endif

// 1: directions, lobes and their powers keep their digits up to exponents of 1e6 and down to 0. 0: pow() of
// dot products, which errs by about exponent * 2e-7 and is meant for exponents of at least 1.
#ifndef NACRE_STABLE_LOBES
#define NACRE_STABLE_LOBES 1
#endif

// 1: the path through the layer is multiplied out in two parts, so that a thick layer's phase is not
// lost in the rounding of its whole cycles. 0: in one, which below 10 um is as good and cheaper.
#ifndef NACRE_SPLIT_PHASE
#define NACRE_SPLIT_PHASE 1
#endif

// 1: the phase's cosine is the library's polynomial, the same on every driver. 0: the driver's.
#ifndef NACRE_POLYNOMIAL_COSINE
#define NACRE_POLYNOMIAL_COSINE 1
#endif

// Materials in the uniform block's array, nacre_material(index). 64 fit into every driver's 16 KiB.
#ifndef NACRE_MATERIALS
#define NACRE_MATERIALS 1
#endif

// Lights in the block of nacre_light_block.glsl. 255 fit into every driver's 16 KiB.
#ifndef NACRE_MAX_LIGHTS
#define NACRE_MAX_LIGHTS 4
#endif

// nacre::LightKind
#define NACRE_LIGHT_DIRECTIONAL 0
#define NACRE_LIGHT_POINT 1
#define NACRE_LIGHT_SPOT 2

// The fringe table's layout, nacre::FringeTable.
#define NACRE_FRINGE_TEXELS 1024.0
#define NACRE_FRINGE_RANGE_UM 10.0
#define NACRE_FRINGE_ROWS 32.0
#define NACRE_FRINGE_PHASES 4.0

// nacre::Quality
#define NACRE_QUALITY_PAPER 0
#define NACRE_QUALITY_PHYSICAL 1

// What lies below the layer, as the shaders tell it apart: an F0 colour has become an index.
#define NACRE_SUBSTRATE_DIELECTRIC 0
#define NACRE_SUBSTRATE_METAL 1

#endif
