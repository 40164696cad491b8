#ifndef NACRE_QUALITY_GLSL
#define NACRE_QUALITY_GLSL

// For a shader that serves materials of either quality: what the material's own asks for, at the
// price of a branch. A shader of one quality calls nacre_light or nacre_physicalLight itself, with the
// view that goes with it.
vec3 nacre_qualityLight(nacre_Material m, nacre_PhysicalView w, vec3 l)
{
    return m.quality == NACRE_QUALITY_PHYSICAL ? nacre_physicalLight(m, w, l) : nacre_light(m, w.layer, l);
}

vec3 nacre_qualityLight(nacre_Material m, nacre_PhysicalView w, vec3 l, sampler2D fringeTable)
{
    if (m.quality == NACRE_QUALITY_PHYSICAL) return nacre_physicalLight(m, w, l, fringeTable);
    return nacre_light(m, w.layer, l);
}

#endif
