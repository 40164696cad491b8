#include "llvmpipe.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "gl_candidate.hpp"
#include "shader_text.hpp"

namespace nacre::bench {
namespace {

constexpr int width = 1024;
constexpr int checkSide = 64;

// The std140 layout of bench_Frame in glsl/frame.glsl.
struct Frame {
    float pixelSize[2];
    std::int32_t lightCount;
    std::int32_t padding;
    float lights[maxLights][4];
};

Frame makeFrame(int pictureWidth, int height, int lights)
{
    Frame frame{};
    frame.pixelSize[0] = 1.0F / static_cast<float>(pictureWidth);
    frame.pixelSize[1] = 1.0F / static_cast<float>(height);
    frame.lightCount = lights;
    // On a sunflower's spiral above the surface, which reaches from -1 to 1: evenly spread, the first
    // one near the middle, so that highlights fall into the picture.
    for (int i = 0; i < maxLights; ++i) {
        const double angle = 2.399963 * i, radius = 2.0 * std::sqrt((i + 0.5) / maxLights);
        const double position[] = {radius * std::cos(angle), radius * std::sin(angle), 3.0, 1.0};
        for (int k = 0; k < 4; ++k) frame.lights[i][k] = static_cast<float>(position[k]);
    }
    return frame;
}

// What this thread computed: llvmpipe draws in it, and what others do with the machine's cores
// meanwhile counts less than on a clock on the wall.
double threadSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// A floating-point picture and the frame's uniform buffer.
class Target {
public:
    Target(const demo::GlFunctions& gl, int pictureWidth, int height, int lights, bool halfFloat)
        : gl_(gl), width_(pictureWidth), height_(height)
    {
        gl_.GenTextures(1, &texture_);
        gl_.BindTexture(GL_TEXTURE_2D, texture_);
        gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, halfFloat ? GL_RGBA16F : GL_RGBA32F, width_, height_, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl_.BindTexture(GL_TEXTURE_2D, 0);
        gl_.GenFramebuffers(1, &framebuffer_);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
        gl_.Viewport(0, 0, width_, height_);

        const Frame frame = makeFrame(width_, height_, lights);
        gl_.GenBuffers(1, &frame_);
        gl_.BindBuffer(GL_UNIFORM_BUFFER, frame_);
        gl_.BufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STATIC_DRAW);
        gl_.BindBufferBase(GL_UNIFORM_BUFFER, GlCandidate::frameBinding, frame_);
    }

    ~Target()
    {
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteTextures(1, &texture_);
        gl_.DeleteBuffers(1, &frame_);
    }

    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    bool isComplete() const { return gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE; }

    double draw() const
    {
        const double start = threadSeconds();
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
        gl_.Finish();
        return threadSeconds() - start;
    }

    std::vector<float> pixels() const
    {
        std::vector<float> values(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3);
        gl_.ReadPixels(0, 0, width_, height_, GL_RGB, GL_FLOAT, values.data());
        return values;
    }

private:
    const demo::GlFunctions& gl_;
    int width_, height_;
    GLuint texture_ = 0, framebuffer_ = 0, frame_ = 0;
};

// Why a picture cannot be a candidate's; empty where it can.
std::string fault(const std::vector<float>& pixels)
{
    const auto isFinite = [](float value) { return std::isfinite(value); };
    if (!std::all_of(pixels.begin(), pixels.end(), isFinite)) return "the picture has values that are not finite";
    for (std::size_t i = 3; i < pixels.size(); ++i) {
        if (pixels[i] != pixels[i % 3]) return {};
    }
    return "all pixels of the picture are equal";
}

// Compared bit by bit on purpose: whatever is read shows in some pixel.
std::string check(const demo::GlFunctions& gl, const Candidate& candidate, const GlCandidate& made)
{
    for (const int lights : {1, 4}) {
        const Target target(gl, checkSide, checkSide, lights, false);
        const auto draw = [&](GlCandidate::Inputs inputs) {
            made.use(gl, lights == 1, inputs);
            target.draw();
            return target.pixels();
        };
        const std::vector<float> picture = draw(GlCandidate::Inputs::bound);
        const std::string found = fault(picture);
        if (!found.empty()) return found;
        if (!candidate.block.empty() && draw(GlCandidate::Inputs::zeroBlock) == picture) {
            return "the picture does not depend on the block " + candidate.blockName;
        }
        if (!candidate.tables.empty() && draw(GlCandidate::Inputs::zeroTables) == picture) {
            return "the picture does not depend on the tables";
        }
    }
    if (const GLenum error = gl.GetError()) return "OpenGL error " + std::to_string(error);
    return {};
}

struct Runner {
    std::size_t candidate;  // index in the caller's list
    GlCandidate gl;
};

// Seconds per round and runner.
std::vector<std::vector<double>> timeRounds(const demo::GlFunctions& gl, const Target& target, const std::vector<Runner>& runners,
                                            bool oneLight, int rounds, const std::function<void(int)>& roundDone)
{
    std::vector<std::vector<double>> seconds(static_cast<std::size_t>(rounds), std::vector<double>(runners.size()));
    for (int round = -1; round < rounds; ++round) {  // the first one warms up
        for (std::size_t i = 0; i < runners.size(); ++i) {
            // Each round begins with another one, so that none always follows the same neighbour.
            const std::size_t at = (i + static_cast<std::size_t>(round + 1)) % runners.size();
            runners[at].gl.use(gl, oneLight);
            const double time = target.draw();
            if (round >= 0) seconds[static_cast<std::size_t>(round)][at] = time;
        }
        roundDone(round + 1);
    }
    return seconds;
}

// Runner 0 is flat.
LlvmpipeTime summarizeRunner(const std::vector<std::vector<double>>& seconds, std::size_t runner, std::size_t reference, double pixels)
{
    std::vector<double> absolute, increments, ratios;
    for (const std::vector<double>& round : seconds) {
        absolute.push_back(1e9 * round[runner] / pixels);
        increments.push_back(1e9 * (round[runner] - round[0]) / pixels);
        if (reference < round.size()) ratios.push_back((round[runner] - round[0]) / (round[reference] - round[0]));
    }
    LlvmpipeTime time;
    time.nsPerPixel = summarize(absolute);
    time.increment = summarize(increments);
    time.ratio = summarize(ratios);
    return time;
}

}  // namespace

Result<LlvmpipeReport> measureLlvmpipe(const std::vector<Candidate>& candidates, std::size_t reference, const LlvmpipePlan& plan,
                                       const std::function<void(double)>& progress)
{
    drawInCallingThread();
    Result<demo::Context> context = demo::Context::create();
    if (!context) return context.error();
    LlvmpipeReport report;
    report.renderer = context->renderer();
    if (report.renderer.find("llvmpipe") == std::string::npos) return Error{"expected llvmpipe, got " + report.renderer};
    const demo::GlFunctions& gl = context->gl();
    GLuint vertexArray = 0;
    gl.GenVertexArrays(1, &vertexArray);
    gl.BindVertexArray(vertexArray);

    std::vector<Runner> runners;
    std::size_t referenceRunner = candidates.size();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        Result<GlCandidate> made = GlCandidate::create(gl, candidates[i]);
        const std::string found = made ? check(gl, candidates[i], *made) : made.error().message;
        if (!found.empty()) {
            if (i == 0) return Error{candidates[i].name + ": " + found};
            report.failures.push_back({candidates[i].name, found});
            continue;
        }
        if (i == reference) referenceRunner = runners.size();
        runners.push_back({i, *made});
    }

    const std::size_t settings = plan.megapixels.size() * plan.lights.size();
    std::size_t done = 0;
    for (const double megapixels : plan.megapixels) {
        const int height = std::max(1, static_cast<int>(std::lround(megapixels * 1e6 / width)));
        for (const int lights : plan.lights) {
            const Target target(gl, width, height, lights, plan.halfFloat);
            if (!target.isComplete()) return Error{"the driver cannot render to a floating-point picture of this size"};
            const auto roundDone = [&](int round) {
                progress((static_cast<double>(done) + static_cast<double>(round) / plan.rounds) / static_cast<double>(settings));
            };
            const auto seconds = timeRounds(gl, target, runners, lights == 1, plan.rounds, roundDone);
            for (std::size_t i = 0; i < runners.size(); ++i) {
                LlvmpipeTime time = summarizeRunner(seconds, i, referenceRunner, static_cast<double>(width) * height);
                time.candidate = runners[i].candidate;
                time.lights = lights;
                time.megapixels = megapixels;
                report.times.push_back(time);
            }
            ++done;
        }
    }
    for (const Runner& runner : runners) runner.gl.destroy(gl);
    gl.DeleteVertexArrays(1, &vertexArray);
    return report;
}

}  // namespace nacre::bench
