#pragma once

#include <string>
#include <utility>
#include <variant>

namespace nacre {

/// What went wrong, in one line: what, where, why, what would be right.
struct Error {
    std::string message;
};

/// A value or the reason why there is none. nacre neither throws nor prints: test the result
/// before it is dereferenced.
///
///     if (auto block = nacre::pack(material)) upload(*block);
///     else log(block.error().message);
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    explicit operator bool() const noexcept { return state_.index() == 0; }

    /// The value; only where the result converts to true.
    const T& operator*() const& noexcept { return *std::get_if<0>(&state_); }
    T& operator*() & noexcept { return *std::get_if<0>(&state_); }
    T&& operator*() && noexcept { return std::move(*std::get_if<0>(&state_)); }
    const T* operator->() const noexcept { return std::get_if<0>(&state_); }
    T* operator->() noexcept { return std::get_if<0>(&state_); }

    /// The reason; only where the result converts to false.
    const Error& error() const noexcept { return *std::get_if<1>(&state_); }

private:
    std::variant<T, Error> state_;
};

/// Done, or the reason why not: of what has no value to give.
using Outcome = Result<std::monostate>;

}  // namespace nacre
