#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace nacre::test {

/// Asks again and again until it is so; false after the time that a slow machine may take.
template <class Condition>
bool comesTrue(Condition condition, std::chrono::milliseconds limit = std::chrono::seconds(30))
{
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

/// A program that runs beside the test, and ends with it.
class Process {
public:
    /// A pipe whose end to write is the program's descriptor 3, or none.
    Process(const std::vector<std::string>& command, const std::string& directory, const std::string& output, int descriptor3 = -1)
    {
        std::vector<char*> arguments;
        for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        id_ = fork();
        if (id_ != 0) return;
        const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        if (descriptor3 >= 0) dup2(descriptor3, 3);
        if (chdir(directory.c_str()) == 0) execvp(arguments.front(), arguments.data());
        _exit(127);
    }
    ~Process()
    {
        if (status_ || id_ <= 0) return;
        kill(id_, SIGKILL);
        waitpid(id_, nullptr, 0);
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// The exit status once it has ended, 128 and the signal where it was killed.
    std::optional<int> status()
    {
        int status = 0;
        if (!status_ && waitpid(id_, &status, WNOHANG) == id_) status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return status_;
    }

private:
    pid_t id_ = -1;
    std::optional<int> status_;
};

/// An X server without a screen (Xvfb), as DISPLAY for what the test starts.
class Desktop {
public:
    Desktop()
    {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0) return;
        server_.emplace(std::vector<std::string>{"Xvfb", "-displayfd", "3", "-screen", "0", "2700x1500x24", "-nolisten", "tcp"}, "/", "/dev/null", ends[1]);
        close(ends[1]);
        std::string number;
        for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
        close(ends[0]);
        if (!number.empty()) setenv("DISPLAY", (':' + number).c_str(), 1);
        isUp_ = !number.empty();
    }
    bool isUp() const { return isUp_; }

private:
    std::optional<Process> server_;
    bool isUp_ = false;
};

}  // namespace nacre::test
