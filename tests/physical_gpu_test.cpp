// Quality physical: the GLSL against its double-precision twin, and what hard inputs make of it.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "gpu.hpp"
#include "vectors.hpp"

namespace {

using namespace nacre;
using namespace nacre::test;

std::vector<Case> load(const std::string& name)
{
    std::ifstream file(NACRE_TEST_DATA "/" + name);
    const Result<CsvTable> table = CsvTable::read(file);
    return *readCases(*table);
}

double pick(std::mt19937_64& random, std::initializer_list<double> values)
{
    return values.begin()[random() % values.size()];
}

// The paper's vectors with something below the layer. wild: the ends of every range.
std::vector<Case> cases(const std::string& name, bool isWild)
{
    std::mt19937_64 random(1);
    std::vector<Case> all = load(name);
    for (Case& one : all) {
        Material& m = one.material;
        m.quality = Quality::physical;
        m.substrate = static_cast<Substrate>(random() % 3);
        m.lobes = static_cast<Lobes>(random() % 2);
        for (int channel = 0; channel < 3; ++channel) {
            m.substrateIndex[channel] = isWild ? pick(random, {0.01, 0.3, 1.0, 1.5, m.ior[channel], 4.0, 100.0}) : pick(random, {0.3, 1.0, 1.5, 2.5});
            m.substrateAbsorption[channel] = isWild ? pick(random, {0.0, 1e-6, 1.0, 7.0, 100.0}) : pick(random, {0.5, 3.0, 6.0});
            m.substrateF0[channel] = isWild ? pick(random, {0.0, 1e-6, 0.5, 0.9999, 1.0}) : pick(random, {0.04, 0.5, 0.9});
        }
    }
    return all;
}

std::vector<GpuOutput> onGpu(const std::vector<Case>& all, FringeForm form)
{
    const Result<GpuEvaluator> evaluator = GpuEvaluator::create(context(), form);
    if (!evaluator) throw std::runtime_error(evaluator.error().message);
    std::vector<GpuInput> inputs;
    for (const Case& one : all) inputs.push_back(*gpuInput(one));
    return *evaluator->run(inputs);
}

double worstDifference(const std::vector<Case>& all, FringeForm form)
{
    const Result<FringeTable> table = FringeTable::create();
    const std::vector<GpuOutput> outputs = onGpu(all, form);
    double worst = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Evaluation expected = *evaluate(all[i], form == FringeForm::table ? &*table : nullptr);
        for (int channel = 0; channel < 3; ++channel) {
            const auto compare = [&](double got, double wanted, double scale) {
                const double error = std::fabs(got - wanted) / std::max(1.0, scale);
                if (!(error <= worst)) worst = error;
            };
            compare(static_cast<double>(outputs[i].rho[channel]), expected.rho[channel], expected.R[channel] + expected.T[channel]);
            compare(static_cast<double>(outputs[i].diffuse[channel]), expected.diffuse[channel], 1.0);
            compare(static_cast<double>(outputs[i].shaded[channel]), expected.shaded[channel], expected.R[channel] + expected.T[channel]);
        }
    }
    return worst;
}

// float32: 1e-5 is what the lobes' powers and the fringes' phase leave together, some hundred operations.
TEST(PhysicalGpu, LinesMatchTheTwin)
{
    EXPECT_LE(worstDifference(cases("typical.csv", false), FringeForm::analytic), 1e-5);
}

// A driver may place a sample between two texels in steps of 1/256; a step of the table is up to 0.2, the
// fringes' weight up to 1.
TEST(PhysicalGpu, TableMatchesTheTwin)
{
    EXPECT_LE(worstDifference(cases("typical.csv", false), FringeForm::table), 0.2 / 256.0);
}

TEST(PhysicalGpu, HardInputsStayFiniteAndAreNeverNegative)
{
    const std::vector<Case> all = cases("hard.csv", true);
    for (FringeForm form : {FringeForm::table, FringeForm::analytic}) {
        const std::vector<GpuOutput> outputs = onGpu(all, form);
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            for (const glm::vec3& value : {outputs[i].rho, outputs[i].R, outputs[i].T, outputs[i].diffuse, outputs[i].shaded}) {
                for (int channel = 0; channel < 3; ++channel) {
                    ASSERT_TRUE(std::isfinite(value[channel])) << "row " << i + 1;
                    ASSERT_GE(value[channel], 0.0F) << "row " << i + 1;
                }
            }
        }
    }
}

// A map may hold anything.
TEST(PhysicalGpu, ThicknessThatIsNoneCountsAsNone)
{
    std::vector<Case> all = cases("typical.csv", false);
    all.resize(100);
    for (FringeForm form : {FringeForm::table, FringeForm::analytic}) {
        const Result<GpuEvaluator> evaluator = GpuEvaluator::create(context(), form);
        ASSERT_TRUE(evaluator);
        std::vector<GpuInput> without;
        for (const Case& one : all) without.push_back(*gpuInput(one));
        for (GpuInput& input : without) input.thicknessUm = 0.0F;
        const std::vector<GpuOutput> expected = *evaluator->run(without);
        for (const float thickness : {-1.0F, NAN, INFINITY, -INFINITY, 3e38F}) {
            std::vector<GpuInput> inputs = without;
            for (GpuInput& input : inputs) input.thicknessUm = thickness;
            const std::vector<GpuOutput> got = *evaluator->run(inputs);
            for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i].shaded, expected[i].shaded) << thickness << ", row " << i + 1;
        }
    }
}

}  // namespace
