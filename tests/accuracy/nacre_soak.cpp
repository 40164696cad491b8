// Random and adversarial inputs through the GLSL, held against the double-precision model: see --help.

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>

#include "command_line.hpp"
#include "parallel.hpp"
#include "shade.hpp"
#include "soak.hpp"
#include "vectors.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

constexpr std::uint64_t longSoak = 10000000;  // one that tells how far it is, a tenth at a time

// One batch per core at a time: made in parallel, drawn one after the other (the driver has threads of its
// own), judged in parallel.
Result<SoakTally> soak(const Shade& shade, std::uint64_t count, std::uint64_t seed)
{
    SoakTally total;
    for (std::uint64_t done = 0; done < count;) {
        std::vector<std::size_t> sizes;
        for (std::uint64_t next = done; sizes.size() < cores() && next < count; next += sizes.back()) {
            sizes.push_back(std::min<std::uint64_t>(PointProgram::most, count - next));
        }
        std::vector<SoakBatch> batches(sizes.size());
        inParallel(sizes.size(), [&](std::size_t i) { batches[i] = SoakBatch::make(seed, done / PointProgram::most + i, sizes[i]); });
        for (SoakBatch& batch : batches) {
            Outcome outcome = shade.run(batch.blocks, batch.points, batch.rho, batch.diffuse);
            if (!outcome) return outcome.error();
        }
        std::vector<SoakTally> tallies(sizes.size());
        inParallel(sizes.size(), [&](std::size_t i) { tallies[i] = judge(batches[i]); });
        for (const SoakTally& tally : tallies) total += tally;
        const std::uint64_t before = done;
        for (std::size_t size : sizes) done += size;
        if (count >= longSoak && before * 10 / count != done * 10 / count) {
            std::fprintf(stderr, "%llu %%\n", static_cast<unsigned long long>(done * 10 / count * 10));
        }
    }
    return total;
}

std::string csvTable(const std::vector<Input>& inputs)
{
    std::string text;
    for (const std::string& column : inputColumns()) text += (text.empty() ? "" : ",") + column;
    text += '\n';
    for (const Input& input : inputs) text += csvLine(input) + '\n';
    return text;
}

void print(const SoakTally& tally)
{
    const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    std::printf("NaN %llu, infinite %llu, negative %llu, not 0 without a normal %llu, over the bound %llu\n", number(tally.nan),
                number(tally.infinite), number(tally.negative), number(tally.undirected), number(tally.overBound));
    const auto percent = [&](std::uint64_t part) { return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(tally.channels, 1)); };
    std::printf("within 1e-6 of the model: %.2f %% of the channels, 1e-5: %.2f %%, 1e-4: %.2f %%\n", percent(tally.within[0]),
                percent(tally.within[1]), percent(tally.within[2]));
    std::printf("channels compared with inputs moved by 4 ulp: %llu; of them at a jump of the model, counted apart: %llu\n",
                number(tally.moved), number(tally.atJump));
    // Below the bound the worst says nothing: the search ends once some inputs within 4 ulp explain a result.
    if (!tally.passes()) std::printf("worst error, in bounds: %.3g; for nacre-eval:\n%s", tally.worst, csvTable({tally.worstInput}).c_str());
}

int fail(const Error& error)
{
    std::cerr << "nacre-soak: " << error.message << '\n';
    return 1;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{
        "Runs random inputs and bit patterns near every branch of the model through the GLSL. Fails where a result is NaN, "
        "infinite, negative or farther than 3e-4 max(1, rho, d / 10 um) from what the double-precision model gives for inputs "
        "within 4 ulp. NACRE_CONTEXT=osmesa|egl and GALLIUM_DRIVER choose the driver.",
        "nacre-soak"};
    double count = 1e6;
    std::uint64_t seed = 1;
    app.add_option("--count", count, "Evaluations")->check(CLI::Range(1.0, 1e15))->capture_default_str();
    app.add_option("--seed", seed, "Same seed and count, same inputs")->capture_default_str();
    std::string failures;
    app.add_option("--failures", failures, "Write the cases that fail to this file, for nacre-eval; a thousand at most");
    if (const std::optional<int> status = demo::parseCommandLine(app, argc, argv)) return *status;

    if (!(std::floor(count) == count)) return fail({"--count: expected a whole number"});  // false for NaN
    Result<demo::Context> context = demo::Context::create();
    if (!context) return fail(context.error());
    Result<Shade> shade = Shade::create(*context);
    if (!shade) return fail(shade.error());

    const auto start = std::chrono::steady_clock::now();
    Result<SoakTally> tally = soak(*shade, static_cast<std::uint64_t>(count), seed);
    if (!tally) return fail(tally.error());
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    std::printf("%s, %s: %.0f evaluations, seed %llu, %.1f s\n", context->kind().c_str(), context->renderer().c_str(), std::floor(count),
                static_cast<unsigned long long>(seed), elapsed.count());
    print(*tally);
    if (!failures.empty() && !(std::ofstream(failures) << csvTable(tally->failures))) return fail({failures + ": cannot be written"});
    return tally->passes() ? 0 : 1;
}
