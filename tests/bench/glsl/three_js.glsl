// three.js's MeshPhysicalMaterial with iridescence, direct light only, in the order of its
// ShaderLib/meshphysical.glsl.js: THREE_FUNCTIONS stands for the chunks before its main,
// THREE_MATERIAL for lights_physical_fragment and lights_fragment_begin as far as its loops over
// lights, which are the frame's here. Film and compensation once per pixel, as there.
#define STANDARD
#define PHYSICAL
#define IOR
#define USE_SPECULAR
#define USE_IRIDESCENCE
#define NUM_SUN_LIGHTS 0
#define NUM_DIR_LIGHTS 1
#define NUM_POINT_LIGHTS 0
#define NUM_SPOT_LIGHTS 0
#define NUM_RECT_AREA_LIGHTS 0
#define texture2D texture

// The uniforms of that material as a block, so that they are read as nacre's are.
layout(std140) uniform bench_Material {
    vec3 diffuse;
    float opacity;
    vec3 specularColor;
    float roughness;
    float metalness;
    float ior;
    float specularIntensity;
    float iridescence;
    float iridescenceIOR;
};

THREE_FUNCTIONS

#define bench_View PhysicalMaterial

PhysicalMaterial bench_view(bench_Point p)
{
    // What the chunks left out before lights_physical_fragment define, without maps.
    vec4 diffuseColor = vec4(diffuse, opacity);
    float roughnessFactor = roughness;
    float metalnessFactor = metalness;
    vec3 normal = p.normal;
    vec3 nonPerturbedNormal = normal;
    vec3 vViewPosition = p.toViewer;
    const bool isOrthographic = false;
    float iridescenceThicknessMaximum = 1000.0 * p.thicknessUm;  // nm, as from a thickness map

THREE_MATERIAL

    return material;
}

vec3 bench_light(bench_Point p, PhysicalMaterial material, vec3 l)
{
    IncidentLight light = IncidentLight(vec3(1.0), l, true);
    ReflectedLight reflected = ReflectedLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    RE_Direct(light, p.position, p.normal, p.view, vec3(0.0), material, reflected);
    return reflected.directDiffuse + reflected.directSpecular;
}
