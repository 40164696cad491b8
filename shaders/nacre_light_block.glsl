#ifndef NACRE_LIGHT_BLOCK_GLSL
#define NACRE_LIGHT_BLOCK_GLSL

// The lights as one std140 block, nacre::packLights on the host. The count comes first, so that shaders of
// different NACRE_MAX_LIGHTS can read one buffer, each as many as it has room for.
#ifndef NACRE_LIGHT_LAYOUT
#define NACRE_LIGHT_LAYOUT layout(std140)
#endif
NACRE_LIGHT_LAYOUT uniform nacre_Lights {
    int nacre_u_lightCount;
    nacre_LightSource nacre_u_lights[NACRE_MAX_LIGHTS];
};

// How many there are to loop over.
int nacre_lightCount()
{
    return min(nacre_u_lightCount, NACRE_MAX_LIGHTS);
}

nacre_LightSource nacre_lightSource(int index)
{
    return nacre_u_lights[index];
}

#endif
