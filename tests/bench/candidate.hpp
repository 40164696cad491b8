#pragma once

#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <nacre/features.hpp>
#include <nacre/result.hpp>

#include "film_error.hpp"

namespace nacre::bench {

/// A float table that a candidate reads through a sampler. It is really bound in both measurements.
struct Table {
    enum class Filter { nearest, linear };
    enum class Format { float32, float16, unorm8 };

    std::string sampler;  ///< Its name in the GLSL: `uniform sampler1D name;`, or sampler2D where height > 0.
    int width = 0;
    int height = 0;    ///< 0: one-dimensional.
    int channels = 4;  ///< 1, 2 or 4; the sampler gives 0, 0, 1 for those that are missing.
    Filter filter = Filter::linear;
    Format format = Format::float32;
    std::vector<float> texels;  ///< Row by row, width · height · channels.
};

/// What a candidate makes of a film alone, so that its error can be measured beside its speed.
struct FilmHook {
    std::string glsl;  ///< Defines `vec3 bench_film(bench_Film f)`, glsl/film.glsl. Empty: it models no film.
    bool hasMetals = true;  ///< false: compiled for dielectrics below the film only.
    bool hasSubstrate = true;  ///< false: what lies below the film is a perfect mirror whatever the film says.
    /// The bytes of the candidate's block for a film; none: bench_Film says it all.
    std::function<Result<std::vector<unsigned char>>(const test::FilmCase&)> block;
};

/// A shader to be measured: GLSL that shades a point, and what it reads.
///
/// The text defines
///
///     struct bench_View { … };                                     what a view costs once per pixel
///     bench_View bench_view(bench_Point p);
///     vec3 bench_light(bench_Point p, bench_View w, vec3 l);        what each light adds
///
/// and nothing named `main`; bench_Point stands in glsl/frame.glsl. It is compiled twice, as GLSL 330
/// and, for Vulkan, as GLSL 450: uniforms therefore live in one std140 block.
struct Candidate {
    std::string name;
    std::string glsl;
    bool usesLibrary = true;  ///< nacre's functions and nacre_Block stand before the text.
    Features features{};      ///< What the library's text is assembled for.
    bool isDetail = false;    ///< Not a way to shade, but one feature or form of one: not in the charts.
    std::string naiveForm;    ///< Of the library's forms, the one that is made naive; see naive_forms.hpp.

    std::string blockName;  ///< Of the std140 block; empty: none.
    std::vector<unsigned char> block;
    std::vector<Table> tables;

    FilmHook film;
};

/// A candidate that cannot be measured, and why.
struct Failure {
    std::string candidate, message;
};

/// A plain struct as the bytes of a uniform block.
template <class Block>
std::vector<unsigned char> bytesOf(const Block& block)
{
    std::vector<unsigned char> bytes(sizeof block);
    std::memcpy(bytes.data(), &block, sizeof block);
    return bytes;
}

}  // namespace nacre::bench
