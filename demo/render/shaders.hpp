#pragma once

namespace nacre::demo {

// The demo's own shaders. The model is not here: nacre::glsl() stands before the fragment shader.

inline constexpr const char* meshVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
uniform mat4 objectToWorld;
uniform mat3 normalToWorld;
uniform mat4 worldToClip;
uniform vec3 sceneCentre;
uniform float sceneRadius;
out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out vec3 noisePosition;

void main()
{
    vec4 world = objectToWorld * vec4(position, 1.0);
    worldPosition = world.xyz;
    worldNormal = normalToWorld * normal;
    mat3 linear = mat3(objectToWorld);
    worldTangent = vec4(linear * tangent.xyz, tangent.w * sign(determinant(linear)));  // a mirror turns it
    // The noise lives in the scene scaled to radius 1: models come in every unit of length.
    noisePosition = (world.xyz - sceneCentre) / sceneRadius;
    gl_Position = worldToClip * world;
}
)";

inline constexpr const char* meshFragmentShader = R"(
const int LIGHTS = 4;
uniform vec3 lightDirection[LIGHTS];  // to the light, unit
uniform float lightRadiance[LIGHTS];
uniform vec3 eye;
#if NACRE_PHYSICAL && NACRE_FRINGE_TABLE
uniform sampler2D fringeTable;
#define FRINGES , fringeTable
#else
#define FRINGES
#endif
in vec3 worldPosition;
in vec3 worldNormal;
in vec4 worldTangent;
in vec3 noisePosition;
out vec4 colour;

void main()
{
    nacre_Material m = nacre_materialFromUniforms();
    vec3 normal = gl_FrontFacing ? worldNormal : -worldNormal;  // both sides of a sheet are seen
    nacre_Surface s = nacre_surface(m, normal, worldTangent, noisePosition, mat3(1.0));
    vec3 v = normalize(eye - worldPosition);
    colour = vec4(0.0, 0.0, 0.0, 1.0);
    nacre_Shading w = nacre_shading(m, s, v FRINGES);
    for (int i = 0; i < LIGHTS; ++i) colour.rgb += lightRadiance[i] * nacre_shade(m, w, lightDirection[i] FRINGES);
}
)";

}  // namespace nacre::demo
