#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace nacre::test {

struct Finished {
    int status = -1;     ///< Exit status; -1: ended by a signal.
    std::string output;  ///< What it printed on both streams.
};

/// Runs a command line of the shell.
inline Finished run(const std::string& command)
{
    Finished finished;
    std::FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return finished;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) finished.output.append(buffer.data(), count);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) finished.status = WEXITSTATUS(status);
    return finished;
}

}  // namespace nacre::test
