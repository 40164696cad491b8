#include "measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "parallel.hpp"
#include "reference.hpp"

namespace nacre::test {
namespace {

constexpr int ulps = 4;
// Beyond this error a case is examined for a jump. No jump matters that changes ρ by less.
constexpr double suspicious = 1e-5;

struct CaseError {
    double error = 0.0;
    std::size_t index = 0;
    bool isAtJump = false;
};

// NaN sorts nowhere: it counts as infinite.
double errorPerRho(double got, double expected, double rho)
{
    const double error = std::fabs(got - expected) / std::max(1.0, rho);
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

std::vector<Input> makeInputs(const Region& region, std::size_t cases, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Input> inputs;
    for (std::size_t i = 0; i < cases; ++i) inputs.push_back(region.make(random));
    return inputs;
}

// The error at a share of the sorted cases: the smallest one that so many do not exceed.
double percentile(const std::vector<CaseError>& sorted, double share)
{
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::max<std::size_t>(rank, 1) - 1].error;
}

Measurement summary(const Region& region, const char* quantity, std::vector<CaseError> errors, const std::vector<Input>& inputs)
{
    Measurement measurement;
    measurement.region = region.name;
    measurement.quantity = quantity;
    measurement.cases = errors.size();
    errors.erase(std::remove_if(errors.begin(), errors.end(), [](const CaseError& one) { return one.isAtJump; }), errors.end());
    measurement.atJump = measurement.cases - errors.size();
    if (errors.empty()) return measurement;
    std::sort(errors.begin(), errors.end(), [](const CaseError& a, const CaseError& b) { return a.error < b.error; });
    measurement.spread = {percentile(errors, 0.5),  percentile(errors, 0.9), percentile(errors, 0.99),
                          percentile(errors, 0.999), errors.back().error,     inputs[errors.back().index]};
    return measurement;
}

// task(i) for every i < count, on all cores.
template <class Task>
void forEach(std::size_t count, Task task)
{
    inParallel(cores(), [&](std::size_t core) {
        for (std::size_t i = core; i < count; i += cores()) task(i);
    });
}

struct GpuResults {
    std::vector<glm::vec4> rho, diffuse;
};

Result<GpuResults> onGpu(const Shade& shade, const std::vector<Input>& inputs)
{
    GpuResults all, batch;
    for (std::size_t first = 0; first < inputs.size(); first += PointProgram::most) {
        const std::size_t count = std::min(PointProgram::most, inputs.size() - first);
        std::vector<Block> materials;
        std::vector<GpuPoint> points;
        for (std::size_t i = 0; i < count; ++i) {
            Result<Block> block = pack(material(inputs[first + i]));
            if (!block) return block.error();
            materials.push_back(*block);
            points.push_back(point(inputs[first + i], i));
        }
        Outcome outcome = shade.run(materials, points, batch.rho, batch.diffuse);
        if (!outcome) return outcome.error();
        all.rho.insert(all.rho.end(), batch.rho.begin(), batch.rho.end());
        all.diffuse.insert(all.diffuse.end(), batch.diffuse.begin(), batch.diffuse.end());
    }
    return all;
}

bool isAtJump(const Input& input, int channel, double got, double expected)
{
    const double scale = std::max(1.0, expected);
    if (errorPerRho(got, expected, expected) <= suspicious) return false;
    return neighbourhood(input, channel, ulps, got, -suspicious * scale).crossesJump;
}

bool isAtAnyJump(const Input& input)
{
    bool crossesJump = false;
    for (int channel = 0; channel < 3; ++channel) {
        crossesJump |= neighbourhood(input, channel, 1, std::numeric_limits<double>::infinity(), 0.0).crossesJump;
    }
    return crossesJump;
}

}  // namespace

const char* const inputsAlone = "inputs alone";

// ρ, then the diffuse coefficient.
static Result<std::array<Measurement, 2>> measure(const Shade& shade, const Region& region, std::size_t cases, std::uint64_t seed)
{
    const std::vector<Input> inputs = makeInputs(region, cases, seed);
    Result<GpuResults> got = onGpu(shade, inputs);
    if (!got) return got.error();
    std::vector<CaseError> rho(cases), diffuse(cases);
    forEach(cases, [&](std::size_t i) {
        const Reference expected = evaluate(inputs[i]);
        rho[i].index = diffuse[i].index = i;
        for (int channel = 0; channel < 3; ++channel) {
            const double gotRho = got->rho[i][channel];
            rho[i].error = std::max(rho[i].error, errorPerRho(gotRho, expected.rho[channel], expected.rho[channel]));
            rho[i].isAtJump |= isAtJump(inputs[i], channel, gotRho, expected.rho[channel]);
            diffuse[i].error = std::max(diffuse[i].error, errorPerRho(got->diffuse[i][channel], expected.diffuse[channel], expected.rho[channel]));
        }
    });
    return std::array{summary(region, "rho", rho, inputs), summary(region, "diffuse", diffuse, inputs)};
}

Result<std::vector<Measurement>> measureDriver(const demo::Context& context, const std::string& driver, std::size_t cases,
                                               std::uint64_t seed, const PointProgram::Options& options)
{
    Result<Shade> shade = Shade::create(context, options);
    if (!shade) return shade.error();
    std::vector<Measurement> measurements;
    for (const Region& region : regions()) {
        Result<std::array<Measurement, 2>> both = measure(*shade, region, cases, seed);
        if (!both) return both.error();
        measurements.insert(measurements.end(), both->begin(), both->end());
    }
    for (Measurement& measurement : measurements) {
        measurement.driver = driver;
        measurement.renderer = context.renderer();
    }
    return measurements;
}

Result<Measurement> measureRegion(const demo::Context& context, const Region& region, std::size_t cases, std::uint64_t seed,
                                  const PointProgram::Options& options)
{
    Result<Shade> shade = Shade::create(context, options);
    if (!shade) return shade.error();
    Result<std::array<Measurement, 2>> both = measure(*shade, region, cases, seed);
    if (!both) return both.error();
    return both->front();
}

std::vector<Measurement> measureInputs(std::size_t cases, std::uint64_t seed)
{
    std::vector<Measurement> measurements;
    for (const Region& region : regions()) {
        const std::vector<Input> inputs = makeInputs(region, cases, seed);
        std::vector<CaseError> rho(cases), diffuse(cases);
        forEach(cases, [&](std::size_t i) {
            const Sensitivity sensitivity = halfUlpSensitivity(inputs[i]);
            rho[i] = {sensitivity.rho, i, sensitivity.rho > suspicious && isAtAnyJump(inputs[i])};
            diffuse[i] = {sensitivity.diffuse, i, false};
        });
        measurements.push_back(summary(region, "rho", rho, inputs));
        measurements.push_back(summary(region, "diffuse", diffuse, inputs));
    }
    for (Measurement& measurement : measurements) {
        measurement.driver = inputsAlone;
        measurement.renderer = "the double-precision model, every input moved by half an ulp";
    }
    return measurements;
}

}  // namespace nacre::test
