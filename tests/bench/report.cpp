#include "report.hpp"

#include <algorithm>
#include <cstdio>

namespace nacre::bench {
namespace {

std::string fixed(double value, int digits)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string row(const std::vector<std::string>& cells)
{
    std::string text = "|";
    for (const std::string& cell : cells) text += ' ' + cell + " |";
    return text + '\n';
}

// A header, its first column to the left and all others to the right.
std::string header(const std::vector<std::string>& cells)
{
    std::string text = row(cells) + "| --- |";
    for (std::size_t i = 1; i < cells.size(); ++i) text += " ---: |";
    return text + '\n';
}

std::string csvLine(const std::vector<std::string>& cells)
{
    std::string text;
    for (const std::string& cell : cells) text += (text.empty() ? "" : ",") + cell;
    return text + '\n';
}

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

// Inverse throughput over flat, of one light and of a further one.
struct Increment {
    double oneLight = 0.0, furtherLight = 0.0;
};

Increment increment(const RadvShader& shader, const RadvShader& flat)
{
    const auto over = [](std::uint64_t value, std::uint64_t base) { return static_cast<double>(value) - static_cast<double>(base); };
    const double one = over(shader.oneLight.inverseThroughput, flat.oneLight.inverseThroughput);
    return {one, over(shader.twoLights.inverseThroughput, flat.twoLights.inverseThroughput) - one};
}

std::string ratioToReference(const Report& report, const RadvReport& family, const RadvShader& shader)
{
    const RadvShader* flat = find(family, 0);
    const RadvShader* reference = find(family, report.reference);
    if (!reference) return {};
    return fixed(increment(shader, *flat).oneLight / increment(*reference, *flat).oneLight, 3);
}

std::string radvTable(const Report& report, const RadvReport& family)
{
    std::string text = "## " + family.device + ", as compiled by RADV, one light\n\n";
    text += header({"candidate", "instructions", "VGPRs", "SGPRs", "code bytes", "latency", "inverse throughput", "over flat",
                    "of three.js", "further light"});
    for (const RadvShader& shader : family.shaders) {
        const RadvStatistics& s = shader.oneLight;
        const Increment over = increment(shader, *find(family, 0));
        text += row({report.candidates[shader.candidate].name, std::to_string(s.instructions), std::to_string(s.vgprs),
                     std::to_string(s.sgprs), std::to_string(s.codeSize), std::to_string(s.latency),
                     std::to_string(s.inverseThroughput), fixed(over.oneLight, 0), ratioToReference(report, family, shader),
                     fixed(over.furtherLight, 0)});
    }
    return text + '\n';
}

std::string csvName(std::string text)
{
    for (char& character : text) character = character == ',' ? ';' : character;
    return text;
}

}  // namespace

std::string markdown(const Report& report)
{
    std::string text;
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
                                "increment_ns_q3", "ratio_to_three_js", "instructions", "vgprs", "sgprs", "code_bytes", "latency",
                                "inverse_throughput", "increment_inverse_throughput", "further_light_inverse_throughput"});
    if (report.llvmpipe) {
        for (const LlvmpipeTime& time : report.llvmpipe->times) {
            text += csvLine({csvName(report.llvmpipe->renderer), report.candidates[time.candidate].name, fixed(time.megapixels, 3),
                             std::to_string(time.lights), median(time.nsPerPixel, 4), median(time.increment, 4),
                             fixed(time.increment.lowerQuartile, 4), fixed(time.increment.upperQuartile, 4), median(time.ratio, 5),
                             "", "", "", "", "", "", "", ""});
        }
    }
    for (const RadvReport& family : report.radv) {
        for (const RadvShader& shader : family.shaders) {
            const RadvStatistics& s = shader.oneLight;
            const Increment over = increment(shader, *find(family, 0));
            text += csvLine({csvName(family.device), report.candidates[shader.candidate].name, "", "1", "", "", "", "",
                             ratioToReference(report, family, shader), std::to_string(s.instructions), std::to_string(s.vgprs),
                             std::to_string(s.sgprs), std::to_string(s.codeSize), std::to_string(s.latency),
                             std::to_string(s.inverseThroughput), fixed(over.oneLight, 0), fixed(over.furtherLight, 0)});
        }
    }
    return text;
}

}  // namespace nacre::bench
