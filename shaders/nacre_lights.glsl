#ifndef NACRE_LIGHTS_GLSL
#define NACRE_LIGHTS_GLSL

// Directional, point and spot lights: what one of them sends to a point. Khronos, glTF extension
// KHR_lights_punctual.

// As nacre_light_block.glsl has it; nacre::LightSource on the host. Positions and directions are in the space of
// the shaded point.
struct nacre_LightSource {
    vec3 colour;         // linear, times the intensity: lux of a directional light, candela of the others
    float inverseRange;  // 0: it reaches everywhere
    vec3 position;       // of point and spot
    int kind;            // NACRE_LIGHT_*
    vec3 direction;      // unit, the way a directional light or a spot shines
    float angleScale;    // a spot's cone; a point's is 0 with an offset of 1
    float angleOffset;
};

// What arrives: what nacre_shade asks for, and what its result is to be multiplied by.
struct nacre_Incidence {
    vec3 direction;  // to the light, unit; 0 where the light is at the point
    vec3 radiance;   // 0 where nothing arrives
};

// The inverse square with the extension's window, which ends it smoothly at the range:
//   max(min(1 - (d / range)^4, 1), 0) / d^2
// Differs: nothing comes from where the light itself is, and nearer than 1e-6 units, far below any lamp's own
// size, it grows no further, so that no product with it overflows. Nothing comes from so far away that the
// square overflows, where infinity times a window of 0 would be NaN; the comparisons are such that NaN fails them.
float nacre_distanceAttenuation(float squared, float inverseRange)
{
    if (!(squared > 0.0 && squared < 3e38)) return 0.0;
    float share = squared * inverseRange * inverseRange;
    return max(1.0 - share * share, 0.0) / max(squared, 1e-12);
}

// The extension's angular attenuation: 0 at the outer cone, 1 at the inner one, squared.
//   cosTheta   between the way the spot shines and the way from it to the point
float nacre_angularAttenuation(float cosTheta, float angleScale, float angleOffset)
{
    float share = clamp(cosTheta * angleScale + angleOffset, 0.0, 1.0);
    return share * share;
}

nacre_Incidence nacre_incidence(nacre_LightSource source, vec3 position)
{
    if (source.kind == NACRE_LIGHT_DIRECTIONAL) return nacre_Incidence(-source.direction, source.colour);
    vec3 toLight = source.position - position;
    vec3 direction = nacre_direction(toLight);
    float attenuation = nacre_distanceAttenuation(dot(toLight, toLight), source.inverseRange) *
                        nacre_angularAttenuation(-dot(source.direction, direction), source.angleScale, source.angleOffset);
    return nacre_Incidence(direction, source.colour * attenuation);
}

#endif
