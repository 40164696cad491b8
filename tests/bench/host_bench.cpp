// What the library costs the host: nanoseconds and allocations of setting a material, microseconds of building a variant.

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <nacre/block.hpp>
#include <nacre/features.hpp>
#include <nacre/glsl.hpp>
#include <nacre/lights.hpp>
#include <nacre/presets.hpp>
#include <nacre/uniforms.hpp>

#include "allocations.hpp"
#include "gl/context.hpp"
#include "gl/program.hpp"
#include "null_gl.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

// Times the work and counts what it allocates each time.
template <class Work>
void measure(benchmark::State& state, const Work& work)
{
    work();  // what is made once is not counted
    const std::size_t before = allocations();
    for ([[maybe_unused]] auto _ : state) work();
    const std::size_t made = allocations() - before;
    state.counters["allocations"] = benchmark::Counter(static_cast<double>(made), benchmark::Counter::kAvgIterations);
}

// Nothing is known at compile time of what the library gets.
Material material(Quality quality)
{
    Material result = *preset("figure-3-right");
    result.quality = quality;
    benchmark::DoNotOptimize(result);
    return result;
}

void pack(benchmark::State& state, Quality quality)
{
    const Material given = material(quality);
    measure(state, [&] { benchmark::DoNotOptimize(nacre::pack(given)); });
}

void copyToArray(benchmark::State& state)
{
    const Block block = *nacre::pack(material(Quality::paper));
    std::vector<Block> buffer(64);
    std::size_t index = 0;
    measure(state, [&] {
        std::memcpy(&buffer[index++ % buffer.size()], &block, sizeof block);
        benchmark::ClobberMemory();
    });
}

void setOnNullGl(benchmark::State& state)
{
    const Uniforms uniforms = *Uniforms::locate(nullGl(), 1);
    const Block block = *nacre::pack(material(Quality::paper));
    measure(state, [&] { uniforms.set(block); });
}

const demo::Context& context()
{
    static const Result<demo::Context> instance = demo::Context::create();
    if (!instance) {
        std::fprintf(stderr, "nacre-host-bench: %s\n", instance.error().message.c_str());
        std::exit(1);
    }
    return *instance;
}

const char* const vertexShader = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
const char* const fragmentMain = R"(
out vec4 colour;
void main()
{
    nacre_Material m = nacre_materialFromUniforms();
    nacre_Surface s = nacre_surface(m, vec3(0.0, 0.0, 1.0), vec4(1.0, 0.0, 0.0, 1.0), gl_FragCoord.xyz, mat3(1.0));
    nacre_Shading w = nacre_shading(m, s, vec3(0.0, 0.6, 0.8));
    colour = vec4(nacre_shade(m, w, normalize(gl_FragCoord.xyz)), 1.0);
}
)";

void setOnDriver(benchmark::State& state)
{
    GlslOptions options;
    options.uniforms = GlslUniforms::plain;
    options.features = *featuresOf(material(Quality::paper));
    const Result<GLuint> program = demo::linkProgram(context().gl(), vertexShader, *glsl(options) + fragmentMain);
    if (!program) {
        state.SkipWithError(program.error().message.c_str());
        return;
    }
    const Uniforms uniforms = *Uniforms::locate(context().getProcAddress(), *program);
    const Block block = *nacre::pack(material(Quality::paper));
    context().gl().UseProgram(*program);
    measure(state, [&] { uniforms.set(block); });
    context().gl().DeleteProgram(*program);
}

void packLight(benchmark::State& state)
{
    LightSource light;
    light.kind = LightKind::spot;
    benchmark::DoNotOptimize(light);
    measure(state, [&] { benchmark::DoNotOptimize(nacre::packLight(light)); });
}

void findFeatures(benchmark::State& state)
{
    const Material given = material(Quality::paper);
    measure(state, [&] { benchmark::DoNotOptimize(featuresOf(given)); });
}

void findKey(benchmark::State& state)
{
    Features features = *featuresOf(material(Quality::paper));
    benchmark::DoNotOptimize(features);
    measure(state, [&] { benchmark::DoNotOptimize(key(features)); });
}

void buildVariant(benchmark::State& state, bool isResolved)
{
    GlslOptions options;
    options.features = *featuresOf(material(Quality::paper));
    options.isResolved = isResolved;
    measure(state, [&] { benchmark::DoNotOptimize(glsl(options)); });
}

}  // namespace

BENCHMARK_CAPTURE(pack, paper, Quality::paper);
BENCHMARK_CAPTURE(pack, physical, Quality::physical);
BENCHMARK(copyToArray);
BENCHMARK(setOnNullGl);
BENCHMARK(setOnDriver);
BENCHMARK(packLight);
BENCHMARK(findFeatures);
BENCHMARK(findKey);
BENCHMARK_CAPTURE(buildVariant, withConditionals, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(buildVariant, resolved, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_MAIN();
