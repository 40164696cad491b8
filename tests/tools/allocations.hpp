#pragma once

#include <cstddef>

namespace nacre::test {

/// How often the program has asked for memory by `new` so far. allocations.cpp replaces the operator: a source of the
/// programs that count, not of a library.
std::size_t allocations() noexcept;

}  // namespace nacre::test
