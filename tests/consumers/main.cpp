// A program of someone else's that embeds nacre.

#include <nacre/nacre.hpp>

#include <cstdio>

int main()
{
    const auto material = nacre::preset("figure-3-right");
    const auto block = nacre::pack(*material);
    const auto source = nacre::glsl();
    const auto evaluation = nacre::evaluate(*material, {{0, 0, 1}, {0, 0, 1}, 70.0}, {0, 0, 1}, {0, 0, 1});
    if (!material || !block || !source || !evaluation || nacre::glslFiles().empty()) return 1;
    std::printf("rho %.6f %.6f %.6f, %zu characters of GLSL\n", evaluation->rho.r, evaluation->rho.g, evaluation->rho.b, source->size());
    return evaluation->rho.r > 0.0 ? 0 : 1;
}
