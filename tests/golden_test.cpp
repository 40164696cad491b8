// A few pictures that were looked at, against what is drawn now.
// Made by: nacre-render --preset NAME --size 256x256 --out tests/golden/NAME.png

#include <gtest/gtest.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <unistd.h>

#include <filesystem>

#include <nacre/presets.hpp>

#include "gpu.hpp"
#include "models.hpp"
#include "render/renderer.hpp"

namespace {

using namespace nacre;
namespace fs = std::filesystem;

class GoldenTest : public testing::TestWithParam<const char*> {};

OIIO::ImageBuf linear(const fs::path& file)
{
    OIIO::ImageBuf image(file.string());
    return OIIO::ImageBufAlgo::colorconvert(image, "sRGB", "linear");
}

// Yee's perceptual measure (2004: visible difference at 100 cd/m² and 45 degrees across the picture) may
// find a difference in at most 0.1 % of the pixels: drivers rasterise an edge differently by a sample.
constexpr double visibleShare = 1e-3;
// And the mean difference of the linear colours stays below a quarter of an 8-bit step of sRGB, 1/255, at
// mid-grey, where a step of sRGB is half as large in linear light.
constexpr double meanDifference = 0.25 / 255.0 / 2.0;

struct Difference {
    int visiblePixels;
    double mean;
};

Difference compare(const OIIO::ImageBuf& one, const OIIO::ImageBuf& other)
{
    OIIO::ImageBufAlgo::CompareResults ignored{};
    return {OIIO::ImageBufAlgo::compare_Yee(one, other, ignored), OIIO::ImageBufAlgo::compare(one, other, 0.0F, 0.0F).meanerror};
}

TEST_P(GoldenTest, LooksAsItDid)
{
    const std::string name = GetParam();
    const Result<demo::Scene> scene = demo::loadScene(demo::shippedModel());
    ASSERT_TRUE(scene) << scene.error().message;
    const Result<demo::Renderer> renderer = demo::Renderer::create(test::context().gl(), *scene);
    ASSERT_TRUE(renderer) << renderer.error().message;
    const Result<demo::Image> image = renderer->render(*preset(name), 256, 256);
    ASSERT_TRUE(image) << image.error().message;
    const fs::path now = fs::temp_directory_path() / ("nacre-golden-" + std::to_string(getpid()) + '-' + name + ".png");
    const Outcome written = demo::writeImage(*image, now);
    ASSERT_TRUE(written) << written.error().message;

    const OIIO::ImageBuf expected = linear(NACRE_TEST_GOLDEN "/" + name + ".png"), got = linear(now);
    ASSERT_EQ(expected.spec().width, 256);
    const Difference difference = compare(expected, got);
    EXPECT_LE(difference.visiblePixels, visibleShare * 256 * 256) << "kept for inspection: " << now;
    EXPECT_LE(difference.mean, meanDifference) << "kept for inspection: " << now;
    if (!HasFailure()) fs::remove(now);
}

// The measure itself: pictures that differ by their deviation alone do not pass for one another.
TEST(Golden, MeasureTellsPresetsApart)
{
    const Difference difference = compare(linear(NACRE_TEST_GOLDEN "/figure-3-left.png"), linear(NACRE_TEST_GOLDEN "/figure-3-right.png"));
    EXPECT_TRUE(difference.visiblePixels > visibleShare * 256 * 256 || difference.mean > meanDifference);
}

INSTANTIATE_TEST_SUITE_P(Presets, GoldenTest, testing::Values("figure-2-centre", "figure-3-left", "figure-3-right", "figure-4", "figure-5-right"));

}  // namespace
