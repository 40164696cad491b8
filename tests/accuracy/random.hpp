#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace nacre::test {

/// Random numbers that are the same with every standard library: its engines are, its distributions are not.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }  ///< [0, 1)
    double uniform(double least, double most) { return least + (most - least) * uniform(); }
    double logUniform(double least, double most) { return least * std::pow(most / least, uniform()); }
    double sign() { return uniform() < 0.5 ? -1.0 : 1.0; }
    bool chance(double probability) { return uniform() < probability; }
    std::size_t index(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }

    template <class T, std::size_t count>
    const T& pick(const T (&values)[count])
    {
        return values[index(count)];
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace nacre::test
