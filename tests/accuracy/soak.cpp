#include "soak.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adversarial.hpp"
#include "reference.hpp"

namespace nacre::test {
namespace {

constexpr std::size_t pointsPerMaterial = 256;
constexpr double relativeBound = 3e-4;
constexpr int ulps = 4;
constexpr std::size_t mostFailures = 1000;

double bound(const Input& input, double rho)
{
    return relativeBound * std::max({1.0, rho, static_cast<double>(input.thicknessUm) / 10.0});
}

void count(SoakTally& tally, const Input& input, double errorInBounds)
{
    if (errorInBounds > 1.0 && tally.failures.size() < mostFailures) tally.failures.push_back(input);
    if (errorInBounds <= tally.worst) return;
    tally.worst = errorInBounds;
    tally.worstInput = input;
}

// False for what no error can be measured of.
bool isNumber(SoakTally& tally, const Input& input, float value)
{
    tally.nan += std::isnan(value) ? 1U : 0U;
    tally.infinite += std::isinf(value) ? 1U : 0U;
    tally.negative += value < 0.0F ? 1U : 0U;
    if (std::isfinite(value) && value >= 0.0F) return true;
    count(tally, input, std::numeric_limits<double>::infinity());
    return false;
}

void judgeRho(SoakTally& tally, const Input& input, int channel, double got, double expected)
{
    const double allowed = bound(input, expected);
    double error = std::fabs(got - expected);
    ++tally.channels;
    double limit = 1e-6;
    for (std::uint64_t& within : tally.within) {
        within += error <= allowed / relativeBound * limit ? 1U : 0U;
        limit *= 10.0;
    }
    if (error > allowed) {
        ++tally.moved;
        const Neighbourhood near = neighbourhood(input, channel, ulps, got, allowed);
        error = std::max({0.0, near.least - got, got - near.most});
        if (error > allowed && near.crossesJump) {
            ++tally.atJump;
            return;
        }
        tally.overBound += error > allowed ? 1U : 0U;
    }
    count(tally, input, error / allowed);
}

void judge(SoakTally& tally, const SoakBatch& batch, std::size_t i)
{
    const Input& input = batch.inputs[i];
    const glm::vec4 rho = batch.rho[i], diffuse = batch.diffuse[i];
    const bool isDark = lacksDirection(input.upperNormal) || lacksDirection(input.lowerNormal);
    const bool mayBeDark = isDenormal(input.upperNormal) || isDenormal(input.lowerNormal);
    const bool isZero = glm::vec3(rho) == glm::vec3(0.0F) && glm::vec3(diffuse) == glm::vec3(0.0F);
    if (isDark || mayBeDark) {
        if (isZero) return;
        tally.undirected += isDark ? 1U : 0U;
        if (isDark) count(tally, input, std::numeric_limits<double>::infinity());
    }
    const Reference expected = evaluate(batch.materials[i / pointsPerMaterial], batch.points[i]);
    for (int channel = 0; channel < 3; ++channel) {
        if (isNumber(tally, input, rho[channel]) && !isDark) judgeRho(tally, input, channel, rho[channel], expected.rho[channel]);
        if (isNumber(tally, input, diffuse[channel]) && !isDark) {
            const double error = std::fabs(static_cast<double>(diffuse[channel]) - expected.diffuse[channel]) / bound(input, 0.0);
            tally.overBound += error > 1.0 ? 1U : 0U;
            count(tally, input, error);
        }
    }
}

}  // namespace

SoakBatch SoakBatch::make(std::uint64_t seed, std::uint64_t index, std::size_t count)
{
    std::seed_seq seeds{seed, index};
    std::uint32_t words[2];
    seeds.generate(words, words + 2);
    Random random((std::uint64_t{words[0]} << 32U) | words[1]);

    SoakBatch batch;
    batch.inputs.resize(count);
    batch.points.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        Input& input = batch.inputs[i];
        if (i % pointsPerMaterial == 0) {
            setMaterial(random, input);
            batch.materials.push_back(model::derive(material(input)));
            batch.blocks.push_back(*pack(material(input)));
        } else {
            input = batch.inputs[i - 1];
        }
        setPoint(random, input);
        batch.points.push_back(point(input, batch.materials.size() - 1));
    }
    return batch;
}

SoakTally& SoakTally::operator+=(const SoakTally& other)
{
    nan += other.nan;
    infinite += other.infinite;
    negative += other.negative;
    overBound += other.overBound;
    undirected += other.undirected;
    atJump += other.atJump;
    moved += other.moved;
    channels += other.channels;
    for (std::size_t i = 0; i < within.size(); ++i) within[i] += other.within[i];
    if (other.worst > worst) {
        worst = other.worst;
        worstInput = other.worstInput;
    }
    const std::size_t room = mostFailures - failures.size();
    failures.insert(failures.end(), other.failures.begin(), other.failures.begin() + static_cast<std::ptrdiff_t>(std::min(room, other.failures.size())));
    return *this;
}

SoakTally judge(const SoakBatch& batch)
{
    SoakTally tally;
    for (std::size_t i = 0; i < batch.inputs.size(); ++i) judge(tally, batch, i);
    return tally;
}

}  // namespace nacre::test
