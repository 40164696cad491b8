#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace nacre::demo {

using Json = nlohmann::json;

enum class Need { optional, required };

/// The array of the document that an index points into.
struct IndexedArray {
    std::string_view name;
    std::size_t size;
};

/// Both ends included.
struct IntegerRange {
    std::uint64_t least;
    std::uint64_t most;
};

/// The largest integer that every JSON implementation keeps exact: 2^53 - 1.
constexpr std::uint64_t kMostInteger = 9007199254740991u;

/// Copies members from one JSON object to another and refuses values of a wrong kind or size with a
/// LoadFailure that says where: "accessors[3].count is -1, expected …". Integers arrive as such
/// even when the file spells them 8.0, and nothing is copied deeper than asked for.
class CheckedObject {
public:
    CheckedObject(const Json& from, std::string place);

    const std::string& place() const { return place_; }
    const Json& copy() const { return to_; }
    void set(const char* name, Json value) { to_[name] = std::move(value); }

    /// The member or null.
    const Json* find(const char* name) const;
    std::string placeOf(const char* name) const;

    void copyInteger(const char* name, IntegerRange range, Need need);
    void copyIndex(const char* name, const IndexedArray& array, Need need);
    void copyIndices(const char* name, const IndexedArray& array);
    void copyNumbers(const char* name, std::size_t count);
    void copyBoolean(const char* name);
    /// A string; null when it is absent, which is refused where it is required.
    const std::string* string(const char* name, Need need) const;

private:
    const Json* find(const char* name, Need need) const;

    const Json& from_;
    std::string place_;
    Json to_ = Json::object();
};

/// Refuses a value: "place is 1e300, expected …".
[[noreturn]] void refuse(const std::string& place, const Json& value, const std::string& expected);

/// "nodes", 3 → "nodes[3]"
std::string element(std::string_view array, std::size_t index);

}  // namespace nacre::demo
