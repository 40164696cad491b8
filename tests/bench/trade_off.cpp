#include "trade_off.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "candidates.hpp"
#include "table_text.hpp"

namespace nacre::bench {
namespace {

const RadvShader* shaderOf(const RadvReport& family, std::size_t candidate)
{
    const auto isIt = [&](const RadvShader& shader) { return shader.candidate == candidate; };
    const auto found = std::find_if(family.shaders.begin(), family.shaders.end(), isIt);
    return found == family.shaders.end() ? nullptr : &*found;
}

std::string unitOf(const Report& report, const Measured& cost, const char* counted)
{
    return report.reference < cost.size() && cost[report.reference] ? std::string(referenceName) + " = 1" : std::string(counted) + " over flat";
}

// Over the reference's, where that is known. Noise may leave a candidate nothing over flat, or less: no measurement.
void relate(Measured& cost, std::size_t reference)
{
    const std::optional<double> unit = reference < cost.size() ? cost[reference] : std::nullopt;
    for (std::optional<double>& value : cost) {
        if (value && !(*value > 0.0)) value.reset();
        else if (value && unit && *unit > 0.0) *value /= *unit;
    }
}

// The setting that devices are compared by: the first size, the fewest lights.
std::optional<DeviceCost> llvmpipeCost(const Report& report)
{
    if (!report.llvmpipe || report.llvmpipe->times.empty()) return std::nullopt;
    const std::vector<LlvmpipeTime>& times = report.llvmpipe->times;
    const double megapixels = times.front().megapixels;
    int lights = times.front().lights;
    for (const LlvmpipeTime& time : times) lights = std::min(lights, time.lights);
    DeviceCost device{"llvmpipe", {}, {}, Measured(report.candidates.size())};
    device.title = "llvmpipe, one thread, " + std::to_string(lights) + (lights == 1 ? " light, " : " lights, ") + fixed(megapixels, 2) + " Mpixel";
    for (const LlvmpipeTime& time : times) {
        if (time.lights != lights || time.megapixels != megapixels) continue;
        // The median of the rounds' own ratios, of which each saw one state of the machine.
        if (time.candidate != 0) device.cost[time.candidate] = time.ratio.count > 0 ? time.ratio.median : time.increment.median;
    }
    device.unit = unitOf(report, device.cost, "ns per pixel");
    relate(device.cost, report.reference);
    return device;
}

std::optional<DeviceCost> radvCost(const Report& report, const RadvReport& family)
{
    const RadvShader* flat = shaderOf(family, 0);
    if (!flat) return std::nullopt;
    const bool hasCycles = flat->oneLight.vectorCycles > 0;
    const auto measure = hasCycles ? &RadvStatistics::vectorCycles : &RadvStatistics::inverseThroughput;
    const char* const counted = hasCycles ? "vector cycles" : "inverse throughput";
    DeviceCost device{family.family, {}, {}, Measured(report.candidates.size())};
    device.title = (family.family == "navi21" ? std::string("RDNA2") : family.family) + " by RADV's compiler, " + counted + ", 1 light";
    for (const RadvShader& shader : family.shaders) {
        const double increment = static_cast<double>(shader.oneLight.*measure) - static_cast<double>(flat->oneLight.*measure);
        if (shader.candidate != 0) device.cost[shader.candidate] = increment;
    }
    device.unit = unitOf(report, device.cost, counted);
    relate(device.cost, report.reference);
    return device;
}

// The devices on whose front a candidate is.
std::string frontCell(const std::vector<DeviceCost>& devices, const std::vector<std::vector<bool>>& fronts, std::size_t candidate, const char* separator)
{
    std::string names;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (fronts[i][candidate]) names += (names.empty() ? "" : separator) + devices[i].device;
    }
    return names;
}

// The front of each device, over one set. What only shows a single form's price is no choice.
std::vector<std::vector<bool>> frontsOf(const Report& report, const std::vector<DeviceCost>& devices, std::size_t set)
{
    std::vector<std::vector<bool>> fronts;
    Measured errors = meanErrors(report, set);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (isNaiveForm(report.candidates[i])) errors[i].reset();
    }
    for (const DeviceCost& device : devices) fronts.push_back(onFront(device.cost, errors));
    return fronts;
}

// Candidates in rows, settings in columns; each cell ns over flat per pixel and light, and its ratio to three.js.
std::string scalingTable(const Report& report, const std::string& first, const std::vector<std::string>& columns,
                         const std::vector<std::vector<const LlvmpipeTime*>>& settings)
{
    std::vector<std::string> head{first};
    head.insert(head.end(), columns.begin(), columns.end());
    std::string text = header(head);
    for (std::size_t candidate = 1; candidate < report.candidates.size(); ++candidate) {
        std::vector<std::string> cells{report.candidates[candidate].name};
        bool isTimed = false;
        for (const std::vector<const LlvmpipeTime*>& setting : settings) {
            const auto isIt = [&](const LlvmpipeTime* time) { return time->candidate == candidate; };
            const auto found = std::find_if(setting.begin(), setting.end(), isIt);
            cells.emplace_back();
            if (found == setting.end()) continue;
            isTimed = true;
            cells.back() = fixed((*found)->increment.median / (*found)->lights, 1);
            if ((*found)->ratio.count > 0) cells.back() += " (" + fixed((*found)->ratio.median, 2) + ")";
        }
        if (isTimed) text += row(cells);
    }
    return text + '\n';
}

}  // namespace

std::vector<DeviceCost> deviceCosts(const Report& report)
{
    std::vector<DeviceCost> devices;
    if (std::optional<DeviceCost> device = llvmpipeCost(report)) devices.push_back(*device);
    for (const RadvReport& family : report.radv) {
        if (std::optional<DeviceCost> device = radvCost(report, family)) devices.push_back(*device);
    }
    return devices;
}

Measured meanErrors(const Report& report, std::size_t set)
{
    Measured errors(report.candidates.size());
    if (!report.films) return errors;
    for (const FilmError& error : report.films->errors) {
        if (error.set == set) errors[error.candidate] = error.figures.mean;
    }
    return errors;
}

std::vector<bool> onFront(const Measured& cost, const Measured& error)
{
    constexpr double same = 1.01;
    std::vector<bool> front(cost.size());
    for (std::size_t i = 0; i < cost.size(); ++i) {
        front[i] = cost[i] && error[i];
        for (std::size_t j = 0; j < cost.size() && front[i]; ++j) {
            const bool isAsGood = cost[j] && error[j] && *cost[j] <= *cost[i] && *error[j] <= *error[i] * same;
            if (isAsGood && (*cost[j] < *cost[i] || *error[j] * same < *error[i])) front[i] = false;
        }
    }
    return front;
}

bool isNaiveForm(const Candidate& candidate)
{
    return candidate.isDetail;
}

std::string tradeOffTable(const Report& report)
{
    if (!report.films || report.films->errors.empty()) return {};
    std::vector<DeviceCost> devices = deviceCosts(report);
    if (devices.size() > 2) devices.resize(2);  // llvmpipe and the first family; the CSV has all
    std::vector<std::string> head{"candidate"};
    for (const DeviceCost& device : devices) head.push_back(device.device);
    for (const test::NamedSet& set : test::filmSets()) head.emplace_back(set.name);
    if (!devices.empty()) head.insert(head.end(), {"on the front, dielectrics", "on the front, metals"});

    std::string text = "## Speed and error\n\n" + header(head);
    const auto dielectrics = frontsOf(report, devices, 0), metals = frontsOf(report, devices, 1);
    for (std::size_t candidate = 0; candidate < report.candidates.size(); ++candidate) {
        std::vector<std::string> cells{report.candidates[candidate].name};
        for (const DeviceCost& device : devices) cells.push_back(device.cost[candidate] ? fixed(*device.cost[candidate], 2) : "");
        bool hasError = false;
        for (std::size_t set = 0; set < test::filmSets().size(); ++set) {
            const FilmError* error = find(*report.films, candidate, set);
            cells.emplace_back();
            if (!error) continue;
            hasError = true;
            cells.back() = shortly(error->figures.mean) + " / " + shortly(error->figures.percentile95) + " / " + shortly(error->figures.worst);
        }
        if (!hasError || isNaiveForm(report.candidates[candidate])) continue;  // as close as paper-full; the CSV has them
        if (!devices.empty()) {
            cells.push_back(frontCell(devices, dielectrics, candidate, ", "));
            cells.push_back(frontCell(devices, metals, candidate, ", "));
        }
        text += row(cells);
    }
    text += "\nErrors: CIEDE2000 to the film's spectrum over " + std::to_string(report.films->plan.films) + " random films of each set, seed " +
            std::to_string(report.films->plan.seed) + ": mean / 95 % / worst.";
    for (const DeviceCost& device : devices) text += ' ' + device.device + ": " + device.title + ", " + device.unit + '.';
    return text + " On the front: no other candidate is both faster and closer.\n\n";
}

std::string filmCsv(const Report& report)
{
    std::string text = csvLine({"candidate", "set", "least_nm", "most_nm", "is_whole_set", "films", "mean", "p95", "worst", "front"});
    if (!report.films) return text;
    const std::vector<DeviceCost> devices = deviceCosts(report);
    for (const FilmError& error : report.films->errors) {
        const test::NamedSet& set = test::filmSets()[error.set];
        const auto line = [&](double least, double most, const test::ErrorFigures& f, const char* isWhole, const std::string& front) {
            return csvLine({report.candidates[error.candidate].name, csvName(set.name), fixed(least, 0), fixed(most, 0), isWhole,
                            std::to_string(f.count), fixed(f.mean, 5), fixed(f.percentile95, 5), fixed(f.worst, 5), front});
        };
        text += line(set.leastNm, set.mostNm, error.figures, "1", frontCell(devices, frontsOf(report, devices, error.set), error.candidate, ";"));
        for (const test::Band& band : error.bands) text += line(band.leastNm, band.mostNm, band.figures, "0", "");
    }
    return text;
}

std::string scalingTables(const Report& report)
{
    if (!report.llvmpipe) return {};
    std::set<int> lights;
    std::set<double> sizes;
    for (const LlvmpipeTime& time : report.llvmpipe->times) {
        lights.insert(time.lights);
        sizes.insert(time.megapixels);
    }
    const auto settingsOf = [&](int light, double size) {
        std::vector<const LlvmpipeTime*> setting;
        for (const LlvmpipeTime& time : report.llvmpipe->times) {
            if (time.lights == light && time.megapixels == size) setting.push_back(&time);
        }
        return setting;
    };
    std::string text;
    const std::string what = "ns over flat per pixel and light (" + std::string(referenceName) + " = 1)";
    if (lights.size() > 1) {
        // The size nearest to 1 Mpixel.
        const auto isNearer = [](double a, double b) { return std::fabs(a - 1.0) < std::fabs(b - 1.0); };
        const double size = *std::min_element(sizes.begin(), sizes.end(), isNearer);
        std::vector<std::string> columns;
        std::vector<std::vector<const LlvmpipeTime*>> settings;
        for (const int light : lights) {
            columns.push_back(std::to_string(light) + (light == 1 ? " light" : " lights"));
            settings.push_back(settingsOf(light, size));
        }
        text += "## By lights, " + fixed(size, 2) + " Mpixel: " + what + "\n\n" + scalingTable(report, "candidate", columns, settings);
    }
    if (sizes.size() > 1) {
        std::vector<std::string> columns;
        std::vector<std::vector<const LlvmpipeTime*>> settings;
        for (const double size : sizes) {
            columns.push_back(fixed(size, 2) + " Mpixel");
            settings.push_back(settingsOf(*lights.begin(), size));
        }
        text += "## By size, " + std::to_string(*lights.begin()) + (*lights.begin() == 1 ? " light: " : " lights: ") + what + "\n\n" +
                scalingTable(report, "candidate", columns, settings);
    }
    return text;
}

}  // namespace nacre::bench
