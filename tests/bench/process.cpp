#include "process.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <sstream>

extern char** environ;

namespace nacre::bench {
namespace {

// What a program says of its failure: its first line with "error" in it, else the last one.
std::string complaint(const std::string& text)
{
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        if (line.find("error") != std::string::npos || line.find("ERROR") != std::string::npos) return line;
        if (!line.empty()) last = line;
    }
    return last;
}

}  // namespace

Result<std::string> run(const std::vector<std::string>& command)
{
    std::array<int, 2> output{};
    if (pipe(output.data()) != 0) return Error{command[0] + ": cannot make a pipe"};
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output[1], STDERR_FILENO);
    posix_spawn_file_actions_addclose(&actions, output[0]);

    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t process = 0;
    const int failure = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(output[1]);
    if (failure != 0) {
        close(output[0]);
        return Error{command[0] + ": " + std::strerror(failure)};
    }

    std::string text;
    std::array<char, 4096> chunk{};
    for (ssize_t count = 0; (count = read(output[0], chunk.data(), chunk.size())) > 0;) {
        text.append(chunk.data(), static_cast<std::size_t>(count));
    }
    close(output[0]);
    int status = 0;
    waitpid(process, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return Error{command[0] + " failed: " + complaint(text)};
    return text;
}

}  // namespace nacre::bench
