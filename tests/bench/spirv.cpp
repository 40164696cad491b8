#include "spirv.hpp"

#include <cstring>

#include "process.hpp"
#include "text_file.hpp"

namespace nacre::bench {

Result<Spirv> compileSpirv(const std::string& glsl, Stage stage, const std::vector<std::string>& names,
                           const std::filesystem::path& folder)
{
    const std::string stageName = stage == Stage::vertex ? "vert" : "frag";
    const std::string input = (folder / ("shader." + stageName)).string(), output = input + ".spv";
    Result<std::string> written = writeText(input, glsl);
    if (!written) return written.error();
    std::vector<std::string> command{"glslangValidator", "-V", "-S", stageName, "--auto-map-bindings"};
    for (std::size_t binding = 0; binding < names.size(); ++binding) {
        for (const std::string& word : {std::string("--resource-set-binding"), stageName, names[binding], std::string("0"), std::to_string(binding)}) {
            command.push_back(word);
        }
    }
    command.insert(command.end(), {"-o", output, input});
    Result<std::string> compiled = run(command);
    if (!compiled) return compiled.error();
    Result<std::string> bytes = readText(output);
    if (!bytes) return bytes.error();
    Spirv words(bytes->size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes->data(), words.size() * sizeof(std::uint32_t));
    return words;
}

std::vector<std::string> bindingNames(const Candidate& candidate)
{
    std::vector<std::string> names{"bench_Frame"};
    if (!candidate.blockName.empty()) names.push_back(candidate.blockName);
    for (const Table& table : candidate.tables) names.push_back(table.sampler);
    return names;
}

}  // namespace nacre::bench
