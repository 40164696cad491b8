#include "radv.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "shader_text.hpp"
#include "vulkan_compiler.hpp"

namespace nacre::bench {
namespace {

namespace fs = std::filesystem;

struct Shaders {
    std::size_t candidate;
    Spirv oneLight, twoLights;
    std::uint32_t uniformBlocks, tables;
};

Result<Shaders> compile(const Candidate& candidate, const fs::path& folder)
{
    Shaders shaders{};
    shaders.uniformBlocks = candidate.blockName.empty() ? 1 : 2;
    shaders.tables = static_cast<std::uint32_t>(candidate.tables.size());
    for (const int lights : {1, 2}) {
        Result<std::string> text = fragmentShader(candidate, Dialect::vulkan, lights);
        if (!text) return text.error();
        Result<Spirv> words = compileSpirv(*text, Stage::fragment, bindingNames(candidate), folder);
        if (!words) return words.error();
        (lights == 1 ? shaders.oneLight : shaders.twoLights) = *words;
    }
    return shaders;
}

// The manifest of RADV's driver, for the loader to take no other; empty where it is not found.
fs::path radvManifest()
{
    for (const char* folder : {"/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/etc/vulkan/icd.d"}) {
        std::error_code error;
        for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
            if (file.path().filename().string().rfind("radeon_icd", 0) == 0) return file.path();
        }
    }
    return {};
}

void setEnvironment(const std::string& family)
{
    if (!std::getenv("VK_ICD_FILENAMES") && !std::getenv("VK_DRIVER_FILES")) {
        const fs::path manifest = radvManifest();
        if (!manifest.empty()) setenv("VK_ICD_FILENAMES", manifest.c_str(), 1);
    }
    setenv("RADV_FORCE_FAMILY", family.c_str(), 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);  // a cached shader may come without statistics
}

void write(std::ostream& stream, const RadvStatistics& s)
{
    stream << ' ' << s.instructions << ' ' << s.vgprs << ' ' << s.sgprs << ' ' << s.codeSize << ' ' << s.latency << ' '
           << s.inverseThroughput << ' ' << s.vectorCycles;
}

std::istream& read(std::istream& stream, RadvStatistics& s)
{
    return stream >> s.instructions >> s.vgprs >> s.sgprs >> s.codeSize >> s.latency >> s.inverseThroughput >> s.vectorCycles;
}

// What the forked process writes: a line with the device's name, then one per candidate; or a line that
// begins with "error ".
std::string measure(const Spirv& vertex, const std::vector<Shaders>& all)
{
    Result<VulkanCompiler> compiler = VulkanCompiler::create();
    if (!compiler) return "error " + compiler.error().message;
    std::ostringstream text;
    text << "device " << compiler->deviceName() << '\n';
    for (const Shaders& shaders : all) {
        text << shaders.candidate;
        for (const Spirv* fragment : {&shaders.oneLight, &shaders.twoLights}) {
            Result<RadvStatistics> found = compiler->fragmentStatistics(vertex, *fragment, shaders.uniformBlocks, shaders.tables);
            if (!found) return "error " + found.error().message;
            write(text, *found);
        }
        text << '\n';
    }
    return text.str();
}

RadvReport parse(const std::string& family, const std::string& text)
{
    RadvReport report;
    report.family = family;
    std::istringstream stream(text);
    std::string kind;
    stream >> kind >> std::ws;
    std::getline(stream, kind == "device" ? report.device : report.failure);
    for (RadvShader shader; stream >> shader.candidate && read(stream, shader.oneLight) && read(stream, shader.twoLights);) {
        report.shaders.push_back(shader);
    }
    return report;
}

RadvReport measureInProcess(const std::string& family, const Spirv& vertex, const std::vector<Shaders>& shaders)
{
    RadvReport report;
    report.family = family;
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
        report.failure = "cannot make a pipe";
        return report;
    }
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process == 0) {
        // RADV warns on standard error that it is not tested for conformance; the report is all we want.
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDERR_FILENO);
        setEnvironment(family);
        const std::string text = measure(vertex, shaders);
        const bool written = ::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
        _exit(written ? 0 : 1);
    }
    close(ends[1]);
    std::string text;
    std::array<char, 4096> chunk{};
    for (ssize_t count = 0; (count = ::read(ends[0], chunk.data(), chunk.size())) > 0;) {
        text.append(chunk.data(), static_cast<std::size_t>(count));
    }
    close(ends[0]);
    int status = 0;
    if (process > 0) waitpid(process, &status, 0);
    if (process < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        report.failure = process < 0 ? "cannot fork" : "the driver ended its process; does it know this family?";
        return report;
    }
    return parse(family, text);
}

}  // namespace

Result<RadvReports> measureRadv(const std::vector<Candidate>& candidates, const std::vector<std::string>& families,
                                const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    Result<Spirv> vertex = compileSpirv(vertexShader(Dialect::vulkan), Stage::vertex, {}, folder);
    if (!vertex) return vertex.error();
    RadvReports reports;
    std::vector<Shaders> all;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        Result<Shaders> shaders = compile(candidates[i], folder);
        if (!shaders) {
            reports.failures.push_back({candidates[i].name, shaders.error().message});
            continue;
        }
        shaders->candidate = i;
        all.push_back(*shaders);
    }
    for (const std::string& family : families) reports.families.push_back(measureInProcess(family, *vertex, all));
    return reports;
}

}  // namespace nacre::bench
