// What a candidate's film alone is asked about: a film in air, lit and seen in the mirror direction. A
// candidate that models one brings
//
//     vec3 bench_film(bench_Film f);   its reflectance in linear Rec.709
//
// beside bench_view and bench_light: the same text that is timed, one film per pixel.
uniform sampler2D bench_films;  // three texels per film

struct bench_Film {
    float index;
    float thicknessUm;
    float cosTheta;
    vec3 substrateReal;       // n below the film, per channel
    vec3 substrateImaginary;  // k; 0: a dielectric
};

bench_Film bench_filmOfPixel()
{
    ivec2 at = ivec2(gl_FragCoord.xy) * ivec2(3, 1);
    vec4 film = texelFetch(bench_films, at, 0);
    vec3 real = texelFetch(bench_films, at + ivec2(1, 0), 0).xyz;
    vec3 imaginary = texelFetch(bench_films, at + ivec2(2, 0), 0).xyz;
    return bench_Film(film.x, film.y, film.z, real, imaginary);
}
