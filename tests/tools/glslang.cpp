#include "glslang.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>
#include <map>
#include <sstream>

#include "process.hpp"

namespace nacre::test {
namespace {

namespace fs = std::filesystem;

// For Vulkan the files of a call are linked to one program, in a time that grows with their number's square.
std::size_t perProcess(Glslang target)
{
    return target == Glslang::opengl ? 200 : target == Glslang::vulkan ? 8 : 1;
}

std::string fileName(std::size_t index)
{
    return std::to_string(index) + ".frag";
}

// A line that has no shader to blame: the files of a call for Vulkan have a main each, which cannot be linked.
bool isOfLinking(const std::string& line)
{
    return line.rfind("ERROR: Linking ", 0) == 0;
}

// Per file what the compiler says below its name.
std::map<std::string, std::string> byFile(const std::string& output)
{
    std::map<std::string, std::string> messages;
    std::string line, file;
    for (std::istringstream lines(output); std::getline(lines, line);) {
        const bool isName = line.size() > 5 && line.compare(line.size() - 5, 5, ".frag") == 0 && line.find(' ') == std::string::npos;
        if (isName) messages[file = line];
        else messages[file] += line + '\n';
    }
    return messages;
}

std::vector<std::string> refusedOf(const fs::path& directory, const std::vector<NamedShader>& shaders, std::size_t first, std::size_t end, Glslang target)
{
    std::string command = "cd '" + directory.string() + "' && glslangValidator";
    if (target != Glslang::opengl) command += " -V -o " + std::to_string(first) + ".spv";
    for (std::size_t i = first; i < end; ++i) {
        std::ofstream(directory / fileName(i)) << shaders[i].text;
        command += ' ' + fileName(i);
    }
    const Finished finished = run(command);
    auto messages = byFile(finished.output);
    if (end - first == 1) messages[fileName(first)] = finished.output;  // the name of a single file is not always said
    std::vector<std::string> refused;
    for (std::size_t i = first; i < end; ++i) {
        const auto message = messages.find(fileName(i));
        bool isTaken = message != messages.end();
        if (isTaken) {
            std::istringstream lines(message->second);
            for (std::string line; std::getline(lines, line);) isTaken = isTaken && (line.rfind("ERROR", 0) != 0 || isOfLinking(line));
        }
        if (!isTaken) refused.push_back(shaders[i].name + '\n' + (message == messages.end() ? finished.output : message->second));
    }
    // The status and the messages have to agree; that of a linked call says nothing.
    const bool hasStatus = target != Glslang::vulkan;
    if (hasStatus && refused.empty() != (finished.status == 0)) refused.push_back(shaders[first].name + " and the next\n" + finished.output);
    for (std::size_t i = first; i < end; ++i) fs::remove(directory / fileName(i));
    return refused;
}

}  // namespace

std::vector<std::string> refusedByGlslang(const std::vector<NamedShader>& shaders, Glslang target)
{
    const fs::path directory = fs::current_path() / ("glslang-" + std::to_string(getpid()));
    fs::create_directory(directory);
    const std::size_t step = perProcess(target);
    const auto half = [&](std::size_t from) {
        std::vector<std::string> refused;
        for (std::size_t first = from * step; first < shaders.size(); first += 2 * step) {
            for (std::string& one : refusedOf(directory, shaders, first, std::min(first + step, shaders.size()), target)) refused.push_back(std::move(one));
        }
        return refused;
    };
    std::future<std::vector<std::string>> other = std::async(std::launch::async, half, 1U);
    std::vector<std::string> refused = half(0U);
    for (std::string& one : other.get()) refused.push_back(std::move(one));
    fs::remove_all(directory);
    return refused;
}

}  // namespace nacre::test
