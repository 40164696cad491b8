#ifndef NACRE_CHANNELS_GLSL
#define NACRE_CHANNELS_GLSL

// A value per channel R, G, B, or one for the three where the layer has one index. The same formulas read
// either; these few functions stand where GLSL tells a vec3 from a float.
#if NACRE_DISPERSION
#define nacre_Channels vec3
#define nacre_ChannelsTest bvec3
#else
#define nacre_Channels float
#define nacre_ChannelsTest bool
#endif

float nacre_channel(float value, int channel) { return value; }
float nacre_channel(vec3 value, int channel) { return value[channel]; }

bool nacre_less(float a, float b) { return a < b; }
bvec3 nacre_less(vec3 a, vec3 b) { return lessThan(a, b); }

bool nacre_any(bool a) { return a; }
bool nacre_any(bvec3 a) { return any(a); }

#endif
