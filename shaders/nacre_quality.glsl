#ifndef NACRE_QUALITY_GLSL
#define NACRE_QUALITY_GLSL

// One name for whatever the switches leave: nacre_shading once per pixel, nacre_shade for each light. A shader for
// both qualities asks the material, at the price of a branch. Those with a fringe table take it as their last
// argument.

#if NACRE_PAPER && NACRE_PHYSICAL

struct nacre_Shading {
    nacre_View paper;  // of these two the one that the material asks for
    nacre_PhysicalView physical;
};

#if NACRE_SAMPLER_FREE
nacre_Shading nacre_shading(nacre_Material m, nacre_Surface s, vec3 v)
{
    nacre_Shading w;
    if (m.quality == NACRE_QUALITY_PHYSICAL) w.physical = nacre_physicalView(m, s, v);
    else w.paper = nacre_view(m, s, v);
    return w;
}

vec3 nacre_shade(nacre_Material m, nacre_Shading w, vec3 l)
{
    if (m.quality == NACRE_QUALITY_PHYSICAL) return nacre_physicalLight(m, w.physical, l);
    return nacre_light(m, w.paper, l);
}
#endif

#if NACRE_FRINGE_TABLE
nacre_Shading nacre_shading(nacre_Material m, nacre_Surface s, vec3 v, sampler2D fringeTable)
{
    nacre_Shading w;
    if (m.quality == NACRE_QUALITY_PHYSICAL) w.physical = nacre_physicalView(m, s, v, fringeTable);
    else w.paper = nacre_view(m, s, v);
    return w;
}

vec3 nacre_shade(nacre_Material m, nacre_Shading w, vec3 l, sampler2D fringeTable)
{
    if (m.quality == NACRE_QUALITY_PHYSICAL) return nacre_physicalLight(m, w.physical, l, fringeTable);
    return nacre_light(m, w.paper, l);
}
#endif

#elif NACRE_PHYSICAL

#define nacre_Shading nacre_PhysicalView

#if NACRE_SAMPLER_FREE
nacre_Shading nacre_shading(nacre_Material m, nacre_Surface s, vec3 v)
{
    return nacre_physicalView(m, s, v);
}

vec3 nacre_shade(nacre_Material m, nacre_Shading w, vec3 l)
{
    return nacre_physicalLight(m, w, l);
}
#endif

#if NACRE_FRINGE_TABLE
nacre_Shading nacre_shading(nacre_Material m, nacre_Surface s, vec3 v, sampler2D fringeTable)
{
    return nacre_physicalView(m, s, v, fringeTable);
}

vec3 nacre_shade(nacre_Material m, nacre_Shading w, vec3 l, sampler2D fringeTable)
{
    return nacre_physicalLight(m, w, l, fringeTable);
}
#endif

#else

#define nacre_Shading nacre_View

nacre_Shading nacre_shading(nacre_Material m, nacre_Surface s, vec3 v)
{
    return nacre_view(m, s, v);
}

vec3 nacre_shade(nacre_Material m, nacre_Shading w, vec3 l)
{
    return nacre_light(m, w, l);
}

#endif

#endif
