#!/bin/sh
# The GLSL alone, without a line of C++: the files as they are, one after the other, through the Khronos
# reference compiler for each version. usage: check.sh SHADERS WORK
set -eu
shaders=$1
work=$2
mkdir -p "$work"
order="config channels material direction power fresnel phase interference upper_lobe lower_lobe diffuse noise thickness lower_normal surface layered complex boundary fringe fringe_table airy physical_lobes physical physical_light quality lights light_block"
checked=0
for version in "330 core" "410 core" "450 core" "300 es" "310 es"; do
    for uniforms in uniforms uniform_block; do
        file="$work/check.frag"
        echo "#version $version" >"$file"
        case $version in *es) printf 'precision highp float;\nprecision highp int;\n' >>"$file" ;; esac
        for name in $order $uniforms material_from_uniforms; do
            cat "$shaders/nacre_$name.glsl" >>"$file"
        done
        cat >>"$file" <<'MAIN'
out vec4 colour;
uniform sampler2D fringeTable;
void main()
{
    nacre_Material m = nacre_materialFromUniforms();
    nacre_Surface s = nacre_surface(m, vec3(0.0, 0.0, 1.0), vec4(1.0, 0.0, 0.0, 1.0), gl_FragCoord.xyz, mat3(1.0));
    nacre_Shading w = nacre_shading(m, s, vec3(0.0, 0.6, 0.8));
    colour = vec4(nacre_shade(m, w, vec3(0.0, 0.0, 1.0)), 1.0);
    w = nacre_shading(m, s, vec3(0.0, 0.6, 0.8), fringeTable);
    for (int i = 0; i < nacre_lightCount(); ++i) {
        nacre_Incidence light = nacre_incidence(nacre_lightSource(i), gl_FragCoord.xyz);
        colour.xyz += light.radiance * nacre_shade(m, w, light.direction, fringeTable);
    }
}
MAIN
        glslangValidator "$file" || { echo "fails as #version $version with nacre_$uniforms.glsl" >&2; exit 1; }
        checked=$((checked + 1))
    done
done
echo "$checked shaders compiled"
