// nacre-view as a user meets it: in a window of a real X server, by mouse and keys (xdotool), on any driver that there is.
// What the window shows is known by its log; every wait is for something to be written there.

#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <thread>

#include "desktop.hpp"
#include "gltf_builder.hpp"
#include "process.hpp"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using nacre::test::comesTrue;
using nacre::test::Desktop;
using nacre::test::Finished;
using nacre::test::Process;

struct Place {
    int left = 0, top = 0, right = 0, bottom = 0;
};

class ViewTest : public testing::Test {
protected:
    static void SetUpTestSuite() { desktop_ = std::make_unique<Desktop>(); }
    static void TearDownTestSuite() { desktop_.reset(); }

    void SetUp() override
    {
        ASSERT_TRUE(desktop_->isUp()) << "Xvfb does not start";
        directory_ = fs::temp_directory_path() / ("nacre-view-test-" + std::to_string(getpid()));
        fs::create_directory(directory_);
    }
    void TearDown() override
    {
        viewer_.reset();
        fs::remove_all(directory_);
    }

    fs::path path(const std::string& name) const { return directory_ / name; }

    void start(std::vector<std::string> options = {})
    {
        if (std::none_of(options.begin(), options.end(), [](const std::string& o) { return o.rfind("--scale", 0) == 0; })) {
            options.insert(options.begin(), "--size=960x560");  // fewer pixels for a driver without a GPU
        }
        options.insert(options.begin(), {NACRE_VIEW, "--gl-debug", "--log", path("log").string()});
        viewer_ = std::make_unique<Process>(options, directory_.string(), path("output").string());
        ASSERT_TRUE(comesTrue([&] { return isSettled() || viewer_->status(); }) && !viewer_->status()) << output();
        // Without a window manager nothing gives a window the keyboard.
        xdotool("search --name nacre-view windowfocus");
    }

    std::string output() const
    {
        std::ifstream stream(path("output"));
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }

    std::vector<std::pair<std::string, std::string>> lines() const
    {
        std::ifstream stream(path("log"));
        std::vector<std::pair<std::string, std::string>> all;
        for (std::string line; std::getline(stream, line) && !stream.eof();) {  // the last one without its end is not whole
            const std::size_t space = line.find(' ');
            all.emplace_back(line.substr(0, space), line.substr(space + 1));
        }
        return all;
    }

    std::string last(const std::string& name) const
    {
        std::string value;
        for (const auto& [key, text] : lines()) {
            if (key == name) value = text;
        }
        return value;
    }
    bool isResting() const
    {
        const auto all = lines();
        return !all.empty() && all.back().first == "rest";
    }
    std::string tail() const
    {
        const auto all = lines();
        std::string text;
        for (std::size_t i = all.size() - std::min<std::size_t>(all.size(), 40); i < all.size(); ++i) text += all[i].first + ' ' + all[i].second + '\n';
        return text;
    }
    long number(const std::string& name) const { return std::atol(last(name).c_str()); }

    void xdotool(const std::string& command) const
    {
        const Finished finished = nacre::test::run("xdotool " + command);
        EXPECT_EQ(finished.status, 0) << command << ": " << finished.output;
    }

    // All that was asked for is seen; the picture may still become finer.
    bool isSettled() const
    {
        const auto all = lines();
        std::string frame, settled;
        for (const auto& [key, text] : all) {
            if (key == "frame") frame = text;
            if (key == "settled") settled = text;
        }
        return !frame.empty() && frame == settled;
    }
    void settle() { ASSERT_TRUE(comesTrue([&] { return isSettled(); })) << output(); }
    void rest() { ASSERT_TRUE(comesTrue([&] { return isResting(); })) << output(); }

    void expectLast(const std::string& name, const std::string& value)
    {
        EXPECT_TRUE(comesTrue([&] { return last(name) == value; })) << name << " is " << last(name) << ", expected " << value << '\n' << output() << tail();
    }

    void move(int x, int y, const std::string& buttons = "000")
    {
        xdotool("mousemove " + std::to_string(x) + ' ' + std::to_string(y));
        expectLast("mouse", std::to_string(x) + ' ' + std::to_string(y) + ' ' + buttons);
        settle();
    }
    // Each step is seen by the viewer before the next one: a slow machine draws few frames.
    void press()
    {
        xdotool("mousedown 1");
        EXPECT_TRUE(comesTrue([&] { return last("mouse").find(" 100") != std::string::npos; })) << last("mouse");
        settle();
    }
    void release()
    {
        xdotool("mouseup 1");
        EXPECT_TRUE(comesTrue([&] { return last("mouse").find(" 000") != std::string::npos; })) << last("mouse");
        settle();
    }
    Place placeOf(const std::string& widget) const
    {
        Place place;
        const std::string text = last("widget:" + widget);
        std::istringstream stream(text);
        EXPECT_TRUE(stream >> place.left >> place.top >> place.right >> place.bottom) << widget << ": '" << text << "'";
        return place;
    }
    void click(const std::string& widget)
    {
        const Place place = placeOf(widget);
        move((place.left + place.right) / 2, (place.top + place.bottom) / 2);
        press();
        release();
    }
    void drag(int fromX, int fromY, int toX, int toY)
    {
        move(fromX, fromY);
        press();
        move(toX, toY, "100");
        release();
    }
    // Down and up again, of that many keys together.
    void key(const std::string& name, int count = 1)
    {
        EXPECT_TRUE(comesTrue([&] { return isSettled() && last("keys").find("held") == std::string::npos; })) << last("keys");
        const long before = number("keys");
        xdotool("key " + name);
        expectLast("keys", std::to_string(before + count));
        settle();
    }
    // Into the field that has just got the keyboard: all that was in it is selected.
    void typeOverAll(const std::string& text)
    {
        expectLast("typing", "1");
        settle();
        xdotool("type --delay 10 '" + text + "'");
    }
    void type(const std::string& field, const std::string& text)
    {
        click(field);
        typeOverAll(text);
        expectLast("text:" + field, text);
        settle();
    }

    // Ctrl+Q; no OpenGL error, no leak, nothing said.
    void expectToClose()
    {
        EXPECT_EQ(last("gl-errors"), "0");
        xdotool("key ctrl+q");
        EXPECT_TRUE(comesTrue([&] { return viewer_->status().has_value(); })) << "it does not close";
        EXPECT_EQ(viewer_->status().value_or(-1), 0) << output();
        EXPECT_EQ(output(), "");
    }

    std::unique_ptr<Process> viewer_;

private:
    static std::unique_ptr<Desktop> desktop_;
    fs::path directory_;
};

std::unique_ptr<Desktop> ViewTest::desktop_;

std::vector<unsigned char> bytesOf(const fs::path& file)
{
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) return {};
    std::vector<unsigned char> bytes(static_cast<std::size_t>(input->spec().width) * static_cast<std::size_t>(input->spec().height) * 3);
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, bytes.data())) return {};
    return bytes;
}

int largestDifference(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
    if (a.size() != b.size() || a.empty()) return 256;
    int largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

TEST_F(ViewTest, DrawsNothingWithoutAChange)
{
    start();
    rest();
    // A moment in which a viewer that redraws would show more frames; sanitized or not, one takes less than a second.
    const long before = number("frame");
    std::this_thread::sleep_for(1500ms);
    EXPECT_EQ(number("frame"), before);
    // And the count does count, with the picture and without.
    const long draws = number("draws");
    move(700, 500);
    move(300, 300);
    EXPECT_GT(number("frame"), before);
    EXPECT_EQ(number("draws"), draws);
    xdotool("key space");
    EXPECT_TRUE(comesTrue([&] { return number("draws") > draws + 3; }));
    xdotool("key space");
    settle();
    expectToClose();
}

TEST_F(ViewTest, PresetSliderAndViewReachThePictureAndItsCommand)
{
    start();
    click("combo##preset");
    click("preset:figure-5-centre");
    expectLast("preset", "figure-5-centre");
    EXPECT_NE(last("material").find("--thickness=79..106"), std::string::npos) << last("material");

    const Place slider = placeOf("upperExponent");
    const int y = (slider.top + slider.bottom) / 2;
    drag((slider.left + slider.right) / 2, y, slider.left + (slider.right - slider.left) * 3 / 4, y);
    // Three quarters of 1 to 10,000 on a logarithmic slider: about 1000.
    const std::string material = last("material");
    const std::size_t at = material.find("--exponents=");
    ASSERT_NE(at, std::string::npos) << material;
    const double exponent = std::atof(material.c_str() + at + std::string("--exponents=").size());
    EXPECT_GT(exponent, 500.0);
    EXPECT_LT(exponent, 2000.0);

    drag(300, 300, 380, 280);
    EXPECT_NE(last("viewpoint").find("--orbit="), std::string::npos) << last("viewpoint");
    xdotool("keydown ctrl");
    drag(300, 300, 420, 340);
    xdotool("keyup ctrl");
    EXPECT_NE(last("viewpoint").find("--light="), std::string::npos) << last("viewpoint");

    click("tab:Export");
    type("picture-size", "160x120");
    click("save-picture");
    EXPECT_TRUE(comesTrue([&] { return !last("saved").empty() || !last("refused").empty(); }));
    EXPECT_EQ(last("refused"), "");
    const std::string command = last("saved");
    ASSERT_EQ(command.rfind("nacre-render --preset=figure-5-centre --exponents=", 0), 0U) << command;
    EXPECT_NE(command.find("--orbit="), std::string::npos) << command;
    const auto renderAgain = [&](const std::string& options) {
        const Finished finished = nacre::test::run("cd '" + path("").string() + "' && " NACRE_RENDER " " + options + " --out=again.png");
        EXPECT_EQ(finished.status, 0) << finished.output;
        return bytesOf(path("again.png"));
    };
    std::string options = command.substr(std::string("nacre-render ").size());
    options.erase(options.find(" --out="));
    const auto saved = bytesOf(path("nacre.png"));
    EXPECT_LE(largestDifference(saved, renderAgain(options)), 1) << command;
    // The comparison tells pictures apart that differ by the slider alone, or by the view alone.
    const std::string otherView = options.substr(0, options.find(" --orbit=")) + " --size=160x120";
    EXPECT_GT(largestDifference(saved, renderAgain(otherView)), 1);
    EXPECT_GT(largestDifference(saved, renderAgain("--preset=figure-5-centre" + options.substr(options.find(" --orbit=")))), 1);

    type("picture-file", "no/such/picture.png");
    key("ctrl+s", 2);
    expectLast("refused", "cannot write 'no/such/picture.png': there is no directory 'no/such'");
    expectToClose();
}

TEST_F(ViewTest, OpensModelsAndRefusesBrokenOnes)
{
    const nacre::test::TemporaryDirectory models;
    const fs::path square = models.write("square.glb", nacre::test::square().glb());
    start();
    const auto open = [&](const std::string& file) {
        expectLast("typing", "0");
        key("ctrl+o", 2);
        typeOverAll(file);
        expectLast("text:model", file);
        key("Return");
    };
    open(NACRE_TEST_DATA "/broken-buffer-index.gltf");
    EXPECT_TRUE(comesTrue([&] { return last("refused").find("broken-buffer-index.gltf': ") != std::string::npos; })) << last("refused");
    settle();
    const long draws = number("draws");
    open(square.string());
    expectLast("opened", square.string());
    EXPECT_TRUE(comesTrue([&] { return number("draws") > draws; }));
    settle();
    click("open-shell");
    EXPECT_TRUE(comesTrue([&] { return last("opened").find("shell.glb") != std::string::npos; }));
    settle();
    expectToClose();
}

TEST_F(ViewTest, ComparesAndMagnifies)
{
    start({"--preset=figure-3-right"});
    for (const char* comparison : {"1 0.500000", "2 0.500000", "3 0.500000"}) {
        key("c");
        expectLast("comparison", comparison);
        settle();
    }
    const Place scene = placeOf("scene");
    const int middle = (scene.left + scene.right) / 2, y = scene.bottom * 2 / 5;
    drag(middle, y, middle - 60, y);
    const double divider = std::atof(last("comparison").c_str() + 2);
    EXPECT_NEAR(divider, 0.5 - 60.0 / (scene.right - scene.left), 0.01);
    EXPECT_EQ(last("viewpoint"), "");

    // The shader's colour at a point on either side, and what double precision makes of it. 1e-4 leaves float32's rounding
    // of position and normal room in a highlight; another pixel or another side would be off by a hundred times that.
    key("m");
    expectLast("magnifier", "1");
    for (const int x : {middle - 120, middle - 20}) {
        const std::string before = last("terms");
        move(x, y);
        ASSERT_TRUE(comesTrue([&] { return last("terms") != before; })) << "nothing is magnified";
        settle();
        double shader[3], host[3];
        ASSERT_EQ(std::sscanf(last("sample").c_str(), "%lf,%lf,%lf", shader, shader + 1, shader + 2), 3) << last("sample");
        ASSERT_EQ(std::sscanf(last("terms").c_str(), "%lf,%lf,%lf", host, host + 1, host + 2), 3) << last("terms");
        for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(shader[channel], host[channel], 1e-4) << x;
        EXPECT_GT(host[0], 0.02) << "the background";
    }
    expectToClose();
}

TEST_F(ViewTest, SurvivesAnySize)
{
    start();
    for (const char* size : {"1 1", "960 560", "200 100", "500 700"}) {
        xdotool("search --name nacre-view windowsize " + std::string(size));
        std::string expected = size;
        std::replace(expected.begin(), expected.end(), ' ', 'x');
        expectLast("window", expected);
        settle();
    }
    key("F1");
    expectLast("help", "1");
    settle();
    expectToClose();
}

TEST_F(ViewTest, ControlsHaveTheirPlaces)
{
    for (const int scale : {1, 2}) {
        start({"--scale=" + std::to_string(scale)});
        const int width = 1280 * scale, height = 720 * scale;
        expectLast("window", std::to_string(width) + 'x' + std::to_string(height));
        std::map<std::string, Place> places;
        for (const auto& [name, value] : lines()) {
            if (name.rfind("widget:", 0) == 0 && value != "hidden") places[name] = placeOf(name.substr(7));
        }
        EXPECT_GT(places.size(), 20U);
        for (const auto& [name, a] : places) {
            EXPECT_TRUE(a.left >= 0 && a.top >= 0 && a.right <= width && a.bottom <= height) << name << " is cut off at scale " << scale;
            for (const auto& [other, b] : places) {
                if (name == other) continue;
                const bool isApart = a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
                EXPECT_TRUE(isApart) << name << " overlaps " << other << " at scale " << scale;
            }
        }
        expectToClose();
    }
}

TEST_F(ViewTest, ShaderFilesReload)
{
    fs::copy(NACRE_SHADERS, path("shaders"));
    start({"--shaders", path("shaders").string()});
    EXPECT_TRUE(comesTrue([&] { return last("shaders") == "good"; })) << last("shaders");
    const fs::path file = path("shaders/nacre_fresnel.glsl");
    std::ifstream stream(file);
    const std::string good((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    const auto write = [&](const std::string& text) { std::ofstream(file) << text; };

    const auto lineCount = std::count(good.begin(), good.end(), '\n');
    write(good + "broken\n");
    EXPECT_TRUE(comesTrue([&] { return last("shaders").find("nacre_fresnel.glsl:" + std::to_string(lineCount + 1)) != std::string::npos; })) << last("shaders");
    settle();
    const long draws = number("draws");
    drag(300, 300, 350, 300);  // the last good ones still draw
    EXPECT_GT(number("draws"), draws);
    fs::remove(file);
    EXPECT_TRUE(comesTrue([&] { return last("shaders").find("cannot read the shader '") == 0; })) << last("shaders");
    write(good);
    EXPECT_TRUE(comesTrue([&] { return last("shaders") == "good"; })) << last("shaders");
    settle();
    expectToClose();
}

TEST_F(ViewTest, SaysInOneLineWhatIsMissing)
{
    const auto expectRefusal = [&](const std::string& environment, const std::string& options, const std::string& part) {
        const Finished finished = nacre::test::run(environment + " " NACRE_VIEW " " + options);
        EXPECT_GT(finished.status, 0) << finished.output;
        EXPECT_EQ(std::count(finished.output.begin(), finished.output.end(), '\n'), 1) << finished.output;
        EXPECT_EQ(finished.output.rfind("nacre-view: ", 0), 0U) << finished.output;
        EXPECT_NE(finished.output.find(part), std::string::npos) << finished.output << " lacks " << part;
    };
    expectRefusal("env -u DISPLAY -u WAYLAND_DISPLAY", "", "no display: ");
    expectRefusal("env -u DISPLAY -u WAYLAND_DISPLAY", "", "; nacre-render draws without a window");
    expectRefusal("MESA_GL_VERSION_OVERRIDE=2.1", "", "no OpenGL 3.3 window: ");
    expectRefusal("MESA_GL_VERSION_OVERRIDE=2.1", "", "; nacre-render draws without a window");
    expectRefusal("", "missing.glb", "'missing.glb'");
    expectRefusal("", "--preset nowhere", "--preset: no preset 'nowhere'");
    expectRefusal("", "--ior -1", "--ior: expected 0.1 <= ior.r <= 10, got -1");
    expectRefusal("", "--size 5", "--size: expected WIDTHxHEIGHT");
    expectRefusal("", "--log no/such/log", "--log: cannot write 'no/such/log'");
}

}  // namespace
