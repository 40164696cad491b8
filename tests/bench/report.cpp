#include "report.hpp"

#include <algorithm>
#include <array>

#include "table_text.hpp"
#include "trade_off.hpp"

namespace nacre::bench {
namespace {

std::string median(const Summary& summary, int digits)
{
    return summary.count > 0 ? fixed(summary.median, digits) : "";
}

std::string quartiles(const Summary& summary, int digits)
{
    return fixed(summary.lowerQuartile, digits) + " - " + fixed(summary.upperQuartile, digits);
}

// Nanoseconds that each further light adds to the increment, from the fewest lights that are looped
// over to the most; empty where there are not two such numbers.
std::string furtherLight(const std::vector<LlvmpipeTime>& times, const LlvmpipeTime& one)
{
    const LlvmpipeTime *fewest = nullptr, *most = nullptr;
    for (const LlvmpipeTime& time : times) {
        if (time.candidate != one.candidate || time.megapixels != one.megapixels || time.lights < 2) continue;
        if (!fewest || time.lights < fewest->lights) fewest = &time;
        if (!most || time.lights > most->lights) most = &time;
    }
    if (fewest == most) return {};
    return fixed((most->increment.median - fewest->increment.median) / (most->lights - fewest->lights), 2);
}

std::string llvmpipeTable(const Report& report)
{
    std::string text = "## " + report.llvmpipe->renderer + ", one thread\n\n";
    text += header({"candidate", "Mpixel", "lights", "ns per pixel", "over flat", "quartiles", "of three.js", "per further light"});
    for (const LlvmpipeTime& time : report.llvmpipe->times) {
        text += row({report.candidates[time.candidate].name, fixed(time.megapixels, 2), std::to_string(time.lights),
                     median(time.nsPerPixel, 2), median(time.increment, 2), quartiles(time.increment, 2), median(time.ratio, 3),
                     furtherLight(report.llvmpipe->times, time)});
    }
    return text + '\n';
}

// Null where the family has no such candidate.
const RadvShader* find(const RadvReport& family, std::size_t candidate)
{
    const auto found = std::find_if(family.shaders.begin(), family.shaders.end(),
                                    [&](const RadvShader& shader) { return shader.candidate == candidate; });
    return found == family.shaders.end() ? nullptr : &*found;
}

// One of the driver's two measures of speed.
using Measure = std::uint64_t RadvStatistics::*;

// What a shader costs over flat, for one light and for a further one.
struct Increment {
    double oneLight = 0.0, furtherLight = 0.0;
};

Increment increment(const RadvShader& shader, const RadvShader& flat, Measure measure)
{
    const auto over = [&](const RadvStatistics& value, const RadvStatistics& base) {
        return static_cast<double>(value.*measure) - static_cast<double>(base.*measure);
    };
    const double one = over(shader.oneLight, flat.oneLight);
    return {one, over(shader.twoLights, flat.twoLights) - one};
}

// Increment, its ratio to three.js's and the increment of a further light; empty where they are not known.
std::array<std::string, 3> measured(const Report& report, const RadvReport& family, const RadvShader& shader, Measure measure)
{
    const RadvShader* flat = find(family, 0);
    const RadvShader* reference = find(family, report.reference);
    if (!flat || flat->oneLight.*measure == 0) return {};
    const Increment over = increment(shader, *flat, measure);
    const std::string ratio = reference ? fixed(over.oneLight / increment(*reference, *flat, measure).oneLight, 3) : "";
    return {fixed(over.oneLight, 0), ratio, fixed(over.furtherLight, 0)};
}

std::string radvTable(const Report& report, const RadvReport& family)
{
    std::string text = "## " + family.device + ", as compiled by RADV, one light\n\n";
    text += header({"candidate", "instructions", "VGPRs", "SGPRs", "code bytes", "latency", "inverse throughput", "over flat",
                    "of three.js", "further light", "vector cycles", "over flat", "of three.js", "further light"});
    for (const RadvShader& shader : family.shaders) {
        const RadvStatistics& s = shader.oneLight;
        const auto weighted = measured(report, family, shader, &RadvStatistics::inverseThroughput);
        const auto all = measured(report, family, shader, &RadvStatistics::vectorCycles);
        text += row({report.candidates[shader.candidate].name, std::to_string(s.instructions), std::to_string(s.vgprs),
                     std::to_string(s.sgprs), std::to_string(s.codeSize), std::to_string(s.latency),
                     std::to_string(s.inverseThroughput), weighted[0], weighted[1], weighted[2], std::to_string(s.vectorCycles),
                     all[0], all[1], all[2]});
    }
    return text + '\n';
}

}  // namespace

std::string markdown(const Report& report)
{
    std::string text = tradeOffTable(report) + scalingTables(report);
    if (report.llvmpipe) text += llvmpipeTable(report);
    for (const RadvReport& family : report.radv) {
        if (!family.shaders.empty()) text += radvTable(report, family);
    }
    for (const std::string& note : report.notes) text += "Note: " + note + "\n";
    return text;
}

std::string csv(const Report& report)
{
    std::string text = csvLine({"device", "candidate", "megapixels", "lights", "ns_per_pixel", "increment_ns", "increment_ns_q1",
                                "increment_ns_q3", "increment_ratio", "instructions", "vgprs", "sgprs", "code_bytes", "latency",
                                "inverse_throughput", "inverse_throughput_increment", "inverse_throughput_ratio",
                                "inverse_throughput_further_light", "vector_cycles", "vector_cycles_increment",
                                "vector_cycles_ratio", "vector_cycles_further_light"});
    const std::vector<LlvmpipeTime> times = report.llvmpipe ? report.llvmpipe->times : std::vector<LlvmpipeTime>();
    for (const LlvmpipeTime& time : times) {
        std::vector<std::string> cells{csvName(report.llvmpipe->renderer), report.candidates[time.candidate].name,
                                       fixed(time.megapixels, 3), std::to_string(time.lights), median(time.nsPerPixel, 4),
                                       median(time.increment, 4), fixed(time.increment.lowerQuartile, 4),
                                       fixed(time.increment.upperQuartile, 4), median(time.ratio, 5)};
        cells.resize(22);
        text += csvLine(cells);
    }
    for (const RadvReport& family : report.radv) {
        for (const RadvShader& shader : family.shaders) {
            const RadvStatistics& s = shader.oneLight;
            const auto weighted = measured(report, family, shader, &RadvStatistics::inverseThroughput);
            const auto all = measured(report, family, shader, &RadvStatistics::vectorCycles);
            text += csvLine({csvName(family.device), report.candidates[shader.candidate].name, "", "1", "", "", "", "", "",
                             std::to_string(s.instructions), std::to_string(s.vgprs), std::to_string(s.sgprs),
                             std::to_string(s.codeSize), std::to_string(s.latency), std::to_string(s.inverseThroughput),
                             weighted[0], weighted[1], weighted[2], std::to_string(s.vectorCycles), all[0], all[1], all[2]});
        }
    }
    return text;
}

}  // namespace nacre::bench
