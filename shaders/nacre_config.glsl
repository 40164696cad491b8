#ifndef NACRE_CONFIG_GLSL
#define NACRE_CONFIG_GLSL

// Every compile-time switch and its default; define one before this file to change it.

// Most octaves of noise, the bound of a loop. The host's range for noiseOctaves ends here too.
#ifndef NACRE_MAX_OCTAVES
#define NACRE_MAX_OCTAVES 8
#endif

// 1: the path through the layer is multiplied out in two parts, so that a thick layer's phase is not
// lost in the rounding of its whole cycles. 0: in one, which below 10 um is as good and cheaper.
#ifndef NACRE_SPLIT_PHASE
#define NACRE_SPLIT_PHASE 1
#endif

// Harmonics of the fringes that quality `physical` sums one by one; a closed form follows for the
// rest. Each costs a look-up in the table (metals: two). At least 1.
#ifndef NACRE_ORDERS
#define NACRE_ORDERS 2
#endif

// 0: quality `physical` takes the boundaries as parallel, which spares it the tilted lobe.
#ifndef NACRE_TILT
#define NACRE_TILT 1
#endif

// 0: one index for all channels, of the layer and of what lies below: the red one's. Nothing is then
// computed three times. (nacre_material_from_uniforms.glsl)
#ifndef NACRE_DISPERSION
#define NACRE_DISPERSION 1
#endif

// 0: what lies below the layer is a dielectric or an F0 colour, never a metal.
// (nacre_material_from_uniforms.glsl)
#ifndef NACRE_METAL
#define NACRE_METAL 1
#endif

// 0: the lobes of quality `physical` are never normalised. (nacre_material_from_uniforms.glsl)
#ifndef NACRE_NORMALISED
#define NACRE_NORMALISED 1
#endif

// The fringe table's layout, nacre::FringeTable: texels along the path, and the path of the last, um.
#define NACRE_FRINGE_TEXELS 1024.0
#define NACRE_FRINGE_RANGE_UM 10.0

// nacre::Quality
#define NACRE_QUALITY_PAPER 0
#define NACRE_QUALITY_PHYSICAL 1

// What lies below the layer, as the shaders tell it apart: an F0 colour has become an index.
#define NACRE_SUBSTRATE_DIELECTRIC 0
#define NACRE_SUBSTRATE_METAL 1

// nacre::LowerNormal
#define NACRE_LOWER_NORMAL_PARALLEL 0
#define NACRE_LOWER_NORMAL_CONSTANT 1
#define NACRE_LOWER_NORMAL_INDEPENDENT 2
#define NACRE_LOWER_NORMAL_GRADIENT 3

#endif
