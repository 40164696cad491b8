// nacre-render as a user meets it: what it writes, and what it says to bad input.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "process.hpp"

namespace {

using nacre::test::Finished;
namespace fs = std::filesystem;

class RenderTest : public testing::Test {
protected:
    void SetUp() override
    {
        directory_ = fs::temp_directory_path() / ("nacre-render-test-" + std::to_string(getpid()));
        fs::create_directory(directory_);
    }
    void TearDown() override { fs::remove_all(directory_); }

    fs::path path(const std::string& name) const { return directory_ / name; }

    Finished render(const std::string& arguments) const
    {
        return nacre::test::run("cd '" + directory_.string() + "' && " NACRE_RENDER " " + arguments);
    }

    // One line that has `part` in it, a status other than 0, and nothing written.
    void expectRefusal(const std::string& arguments, const std::string& part) const
    {
        const auto before = std::distance(fs::directory_iterator(directory_), fs::directory_iterator());
        const Finished finished = render(arguments);
        EXPECT_GT(finished.status, 0) << arguments << ": " << finished.output;
        EXPECT_EQ(std::count(finished.output.begin(), finished.output.end(), '\n'), 1) << finished.output;
        EXPECT_EQ(finished.output.rfind("nacre-render: ", 0), 0U) << finished.output;
        EXPECT_NE(finished.output.find(part), std::string::npos) << finished.output << " lacks " << part;
        EXPECT_EQ(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()), before) << arguments;
    }

private:
    fs::path directory_;
};

TEST_F(RenderTest, WritesPngAsSrgbAndExrAsLinearFloat)
{
    const Finished png = render("--preset figure-3-right --size 40x30 --out a.png");
    ASSERT_EQ(png.status, 0) << png.output;
    EXPECT_EQ(png.output, "");
    const Finished exr = render("--preset figure-3-right --size 40x30 --out a.exr");
    ASSERT_EQ(exr.status, 0) << exr.output;
    const auto a = OIIO::ImageInput::open(path("a.png").string()), b = OIIO::ImageInput::open(path("a.exr").string());
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->spec().width, 40);
    EXPECT_EQ(a->spec().height, 30);
    EXPECT_EQ(a->spec().nchannels, 3);
    EXPECT_EQ(a->spec().format, OIIO::TypeDesc::UINT8);
    EXPECT_EQ(b->spec().format, OIIO::TypeDesc::FLOAT);
    std::vector<float> srgb(40 * 30 * 3), linear(40 * 30 * 3);
    ASSERT_TRUE(a->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, srgb.data()));
    ASSERT_TRUE(b->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, linear.data()));
    for (std::size_t i = 0; i < srgb.size(); ++i) {
        const float x = std::clamp(linear[i], 0.0F, 1.0F);
        const float encoded = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1.0F / 2.4F) - 0.055F;
        ASSERT_NEAR(srgb[i], encoded, 0.51F / 255.0F + 1e-4F);  // half a step of 8 bits, and the converter's own rounding
    }
    EXPECT_GT(*std::max_element(linear.begin(), linear.end()), 0.1F);
}

TEST_F(RenderTest, ParametersChangeThePicture)
{
    ASSERT_EQ(render("--size 32x32 --out a.exr").status, 0);
    ASSERT_EQ(render("--size 32x32 --out b.exr --ior 1.4,1.45,1.6 --thickness 66..76 --deviation 10 --exponents 90,170 --weights 1,0.7").status, 0);
    ASSERT_EQ(render("--size 32x32 --out c.exr --preset figure-3-right --noise-frequency 1.5").status, 0);
    const auto pixels = [&](const char* name) {
        std::vector<float> values(32 * 32 * 3);
        const auto file = OIIO::ImageInput::open(path(name).string());
        EXPECT_TRUE(file && file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data())) << name;
        return values;
    };
    EXPECT_TRUE(pixels("a.exr") != pixels("b.exr"));
    EXPECT_TRUE(pixels("b.exr") == pixels("c.exr"));
}

TEST_F(RenderTest, TheViewpointIsAnOption)
{
    const auto pixels = [&](const std::string& options) {
        std::vector<float> values(32 * 32 * 3);
        const Finished finished = render("--size 32x32 --out a.exr " + options);
        EXPECT_EQ(finished.status, 0) << finished.output;
        const auto file = OIIO::ImageInput::open(path("a.exr").string());
        EXPECT_TRUE(file && file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data())) << options;
        return values;
    };
    const auto usual = pixels("");
    EXPECT_TRUE(pixels("--orbit 20,15 --zoom 1 --target 0,0,0 --light -0.45,0.65,0.75") == usual);
    for (const char* other : {"--orbit 21,15", "--orbit=-20,15", "--zoom 1.5", "--target 0,0.1,0", "--light 0.45,0.65,0.75"}) {
        EXPECT_TRUE(pixels(other) != usual) << other;
    }
}

TEST_F(RenderTest, GalleryHoldsEveryPresetAndASheet)
{
    const Finished finished = render("--gallery pictures --size 48x48");
    ASSERT_EQ(finished.status, 0) << finished.output;
    EXPECT_EQ(finished.output, "");  // no progress bar where there is no terminal
    EXPECT_EQ(std::distance(fs::directory_iterator(path("pictures")), fs::directory_iterator()), 10);
    EXPECT_TRUE(fs::exists(path("pictures/figure-4.png")));
    const auto sheet = OIIO::ImageInput::open(path("pictures/contact-sheet.png").string());
    ASSERT_TRUE(sheet);
    EXPECT_GT(sheet->spec().width, 3 * 48);
}

TEST_F(RenderTest, HelpAndList)
{
    const Finished help = render("--help");
    EXPECT_EQ(help.status, 0);
    for (const char* option : {"--ior", "--thickness", "--deviation", "--exponents", "--weights", "--lower-normal", "--out", "--gallery"}) {
        EXPECT_NE(help.output.find(option), std::string::npos) << option;
    }
    const Finished list = render("--list");
    EXPECT_EQ(list.status, 0);
    EXPECT_NE(list.output.find("figure-5-centre"), std::string::npos);
}

TEST_F(RenderTest, RefusesBadInput)
{
    const std::string out = " --size 16x16 --out x.png ";
    expectRefusal("missing.glb" + out, "'missing.glb'");
    expectRefusal(NACRE_TEST_DATA "/broken-buffer-index.gltf" + out, "broken-buffer-index.gltf'");
    expectRefusal(NACRE_TEST_DATA "/broken-integer-out-of-bounds.gltf" + out, "broken-integer-out-of-bounds.gltf'");
    expectRefusal("--preset nowhere" + out, "--preset: no preset 'nowhere', there are figure-2-left");
    expectRefusal("--size 0x0 --out x.png", "--size: expected WIDTHxHEIGHT");
    expectRefusal("--size 0 --out x.png", "--size");
    expectRefusal("--size -5x5 --out x.png", "--size");
    expectRefusal("--size 5x5x5 --out x.png", "--size");
    expectRefusal("--size 99999x5 --out x.png", "--size: expected a size from 1x1 to");
    expectRefusal("--ior -1" + out, "--ior: expected 0.1 <= ior.r <= 10, got -1");
    expectRefusal("--ior=-1" + out, "--ior: expected 0.1 <= ior.r <= 10, got -1");
    expectRefusal("--ior 1.4,x,1.6" + out, "--ior: expected N or R,G,B in numbers, got '1.4,x,1.6'");
    expectRefusal("--ior 1,2" + out, "--ior");
    expectRefusal("--ior nan" + out, "--ior");
    expectRefusal("--thickness 76..66" + out, "--thickness: expected thicknessLeastNm <= thicknessMostNm (66), got 76");
    expectRefusal("--thickness 66-76" + out, "--thickness: expected N or A..B in numbers, got '66-76'");
    expectRefusal("--exponents 1e9" + out, "--exponents: expected 0 <= upperExponent <= 1000000, got 1e+09");
    expectRefusal("--noise-octaves 1.5" + out, "--noise-octaves: expected a whole number from 0 to 8, got '1.5'");
    expectRefusal("--lower-normal sideways" + out, "--lower-normal: expected one of parallel, constant, independent, gradient, got 'sideways'");
    expectRefusal("--orbit 20" + out, "--orbit: expected AZIMUTH,ELEVATION in numbers, got '20'");
    expectRefusal("--orbit 20,90" + out, "--orbit: expected AZIMUTH,ELEVATION in numbers from -89 to 89, got 90");
    expectRefusal("--zoom 0" + out, "--zoom: expected N in numbers from 0.01 to 1000, got 0");
    expectRefusal("--target 0,nan,0" + out, "--target: expected X,Y,Z in numbers");
    expectRefusal("--light 0,0,0" + out, "--light: expected a direction, got 0,0,0");
    expectRefusal("--unknown 1" + out, "--unknown");
    expectRefusal("--out x.jpg", "--out: cannot write 'x.jpg': expected a name that ends in .png or .exr");
    expectRefusal("--out no/such/x.png", "--out: cannot write 'no/such/x.png': there is no directory 'no/such'");
    expectRefusal("--size 16x16", "expected either --out FILE or --gallery DIR");
    expectRefusal("--gallery g --out x.png", "expected either --out FILE or --gallery DIR");
    expectRefusal("--ior ''" + out, "--ior: expected N or R,G,B in numbers, got ''");
    expectRefusal("--preset ''" + out, "--preset: no preset ''");
    expectRefusal("''" + out, "cannot load ''");
    expectRefusal("--gallery g --size 100000x5", "--size: expected a size from 1x1 to");
    expectRefusal("--gallery /dev/null/x --size 16x16", "cannot make the directory '/dev/null/x'");
}

TEST_F(RenderTest, AFailedWriteLeavesTheOldFile)
{
    ASSERT_EQ(render("--size 16x16 --out x.png").status, 0);
    const auto size = fs::file_size(path("x.png"));
    // A file size limit of one block stops the write half-way, for root too.
    const Finished finished = nacre::test::run("cd '" + path("").string() + "' && trap '' XFSZ; ulimit -f 1; " NACRE_RENDER " --size 400x400 --out x.png");
    EXPECT_EQ(finished.status, 1) << finished.output;
    EXPECT_NE(finished.output.find("'x.png'"), std::string::npos) << finished.output;
    EXPECT_EQ(fs::file_size(path("x.png")), size);
    EXPECT_EQ(std::distance(fs::directory_iterator(path("")), fs::directory_iterator()), 1);
}

}  // namespace
