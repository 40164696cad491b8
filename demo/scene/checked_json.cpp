#include "checked_json.hpp"

#include <cmath>

#include "load_failure.hpp"

namespace nacre::demo {

namespace {

/// Numbers as they are, everything else by its kind: text and arrays may be of any length.
std::string describe(const Json& value) {
    if (value.is_number()) return value.dump();
    return value.is_null() || value.is_boolean() ? value.dump()
                                                 : "of type " + std::string(value.type_name());
}

/// Whether the value is an integer within the range; a cast of 1e300 would be undefined behaviour.
bool toInteger(const Json& value, IntegerRange range, std::uint64_t& integer) {
    if (value.is_number_unsigned()) {
        integer = value.get<std::uint64_t>();
    } else if (value.is_number_float()) {
        const double number = value.get<double>();
        if (!(number >= 0 && number <= static_cast<double>(kMostInteger)) ||
            std::trunc(number) != number) {
            return false;
        }
        integer = static_cast<std::uint64_t>(number);
    } else {
        return false;  // negative integers too: json keeps them apart
    }
    return integer >= range.least && integer <= range.most;
}

std::uint64_t checkedIndex(const Json& value, const std::string& place, const IndexedArray& array) {
    std::uint64_t index = 0;
    if (!toInteger(value, {0, kMostInteger}, index) || index >= array.size) {
        refuse(place, value,
               "an index below " + std::to_string(array.size) + ", the number of " +
                   std::string(array.name));
    }
    return index;
}

}  // namespace

void refuse(const std::string& place, const Json& value, const std::string& expected) {
    throw LoadFailure(place + " is " + describe(value) + ", expected " + expected);
}

std::string element(std::string_view array, std::size_t index) {
    return std::string(array) + '[' + std::to_string(index) + ']';
}

CheckedObject::CheckedObject(const Json& from, std::string place)
    : from_(from), place_(std::move(place)) {
    if (!from_.is_object()) refuse(place_, from_, "an object");
}

std::string CheckedObject::placeOf(const char* name) const {
    return place_.empty() ? name : place_ + '.' + name;
}

const Json* CheckedObject::find(const char* name) const {
    const auto member = from_.find(name);
    return member == from_.end() ? nullptr : &*member;
}

const Json* CheckedObject::find(const char* name, Need need) const {
    const Json* value = find(name);
    if (!value && need == Need::required) {
        throw LoadFailure(placeOf(name) + " is missing, glTF 2.0 requires it");
    }
    return value;
}

void CheckedObject::copyInteger(const char* name, IntegerRange range, Need need) {
    const Json* value = find(name, need);
    if (!value) return;
    std::uint64_t integer = 0;
    if (!toInteger(*value, range, integer)) {
        refuse(
            placeOf(name), *value,
            "an integer from " + std::to_string(range.least) + " to " + std::to_string(range.most));
    }
    to_[name] = integer;
}

void CheckedObject::copyIndex(const char* name, const IndexedArray& array, Need need) {
    if (const Json* value = find(name, need)) {
        to_[name] = checkedIndex(*value, placeOf(name), array);
    }
}

void CheckedObject::copyIndices(const char* name, const IndexedArray& array) {
    const Json* value = find(name);
    if (!value) return;
    if (!value->is_array()) refuse(placeOf(name), *value, "an array of indices");
    Json indices = Json::array();
    for (std::size_t i = 0; i < value->size(); ++i) {
        indices.push_back(checkedIndex((*value)[i], element(placeOf(name), i), array));
    }
    to_[name] = std::move(indices);
}

void CheckedObject::copyNumbers(const char* name, std::size_t count) {
    const Json* value = find(name);
    if (!value) return;
    const std::string expected = "an array of " + std::to_string(count) + " numbers";
    if (!value->is_array()) refuse(placeOf(name), *value, expected);
    if (value->size() != count) {
        throw LoadFailure(placeOf(name) + " has " + std::to_string(value->size()) +
                          " elements, expected " + expected);
    }
    Json numbers = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
        if (!(*value)[i].is_number()) refuse(element(placeOf(name), i), (*value)[i], "a number");
        numbers.push_back((*value)[i].get<double>());
    }
    to_[name] = std::move(numbers);
}

void CheckedObject::copyBoolean(const char* name) {
    const Json* value = find(name);
    if (!value) return;
    if (!value->is_boolean()) refuse(placeOf(name), *value, "true or false");
    to_[name] = value->get<bool>();
}

const std::string* CheckedObject::string(const char* name, Need need) const {
    const Json* value = find(name, need);
    if (!value) return nullptr;
    if (!value->is_string()) refuse(placeOf(name), *value, "a string");
    return value->get_ptr<const std::string*>();
}

}  // namespace nacre::demo
