#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace nacre::test {

inline std::size_t cores()
{
    return std::max(1U, std::thread::hardware_concurrency());
}

/// task(0) ... task(count - 1), each on a thread of its own; returns when all are done.
template <class Task>
void inParallel(std::size_t count, Task task)
{
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < count; ++i) threads.emplace_back(task, i);
    for (std::thread& thread : threads) thread.join();
}

}  // namespace nacre::test
