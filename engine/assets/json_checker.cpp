#include "engine/assets/json_checker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lanthorn {

using nlohmann::json;

namespace {

constexpr std::size_t kShown = 40;  // characters of a wrong value that a message repeats

std::string shown(const json& value) {
    if (value.is_structured()) {
        return fmt::format("an {}", value.type_name());
    }
    std::string text = value.dump();
    return text.size() > kShown ? text.substr(0, kShown) + "..." : text;
}

bool is_float(const json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= std::numeric_limits<float>::max();
}

// Accepts 4.0 for 4, as glTF 2.0, 2.6 (JSON encoding) demands, and stores the integer.
bool normalise_integer(json& value) {
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number >= 0 && number < 9007199254740992.0 && number == std::floor(number)) {
            value = static_cast<std::uint64_t>(number);
        }
    }
    return value.is_number_unsigned() || (value.is_number_integer() && value.get<std::int64_t>() >= 0);
}

std::string expected_index(std::size_t size, std::string_view collection) {
    return size == 0 ? fmt::format("but there are no {}", collection)
                     : fmt::format("expected an index below {} (the number of {})", size, collection);
}

std::size_t collection_size(const json& root, std::string_view collection) {
    const auto found = root.find(collection);
    return found != root.end() && found->is_array() ? found->size() : 0;
}

}  // namespace

std::string JsonPlace::pointer_to(std::string_view key) const {
    std::string result = pointer_ + '/';
    for (const char c : key) {
        if (c == '~') {
            result += "~0";
        } else if (c == '/') {
            result += "~1";
        } else {
            result += c;
        }
    }
    return result;
}

void JsonPlace::refuse(std::string_view problem) const {
    file_->refuse(pointer_.empty() ? "/" : pointer_, problem);
}

void JsonPlace::refuse(std::string_view key, std::string_view problem) const {
    file_->refuse(pointer_to(key), problem);
}

json* JsonPlace::member(std::string_view key, Need need) const {
    const auto found = value_->find(key);
    if (found != value_->end()) {
        return &*found;
    }
    if (need == Need::required) {
        refuse(key, "found nothing, expected this property");
    }
    return nullptr;
}

void JsonPlace::expect_object() const {
    if (!value_->is_object()) {
        refuse(fmt::format("found {}, expected an object", shown(*value_)));
    }
}

bool JsonPlace::boolean(std::string_view key, Need need) const {
    const json* found = member(key, need);
    if (found && !found->is_boolean()) {
        refuse(key, fmt::format("found {}, expected true or false", shown(*found)));
    }
    return found;
}

bool JsonPlace::string(std::string_view key, Need need,
                       std::initializer_list<std::string_view> allowed) const {
    const json* found = member(key, need);
    if (found && !found->is_string()) {
        refuse(key, fmt::format("found {}, expected a string", shown(*found)));
    }
    if (found && allowed.size() > 0 &&
        std::find(allowed.begin(), allowed.end(), found->get_ref<const std::string&>()) == allowed.end()) {
        refuse(key, fmt::format("found {}, expected one of {}", shown(*found), fmt::join(allowed, ", ")));
    }
    return found;
}

bool JsonPlace::number(std::string_view key, Need need) const {
    const json* found = member(key, need);
    if (found && !is_float(*found)) {
        refuse(key, fmt::format("found {}, expected a finite 32-bit number", shown(*found)));
    }
    return found;
}

bool JsonPlace::numbers(std::string_view key, std::size_t size, Need need) const {
    json* found = member(key, need);
    if (!found) {
        return false;
    }
    if (!found->is_array() || found->size() != size) {
        refuse(key, fmt::format("found {}, expected an array of {} numbers",
                                found->is_array() ? fmt::format("{} elements", found->size()) : shown(*found),
                                size));
    }
    expect_floats(key, *found);
    return true;
}

bool JsonPlace::number_list(std::string_view key, Need need) const {
    const json* found = member(key, need);
    if (found && !found->is_array()) {
        refuse(key, fmt::format("found {}, expected an array of numbers", shown(*found)));
    }
    if (found) {
        expect_floats(key, *found);
    }
    return found;
}

void JsonPlace::expect_floats(std::string_view key, const json& array) const {
    for (std::size_t i = 0; i < array.size(); ++i) {
        if (!is_float(array[i])) {
            file_->refuse(fmt::format("{}/{}", pointer_to(key), i),
                          fmt::format("found {}, expected a finite 32-bit number", shown(array[i])));
        }
    }
}

bool JsonPlace::integer(std::string_view key, std::uint64_t low, std::uint64_t high, Need need) const {
    json* found = member(key, need);
    if (!found) {
        return false;
    }
    if (!normalise_integer(*found)) {
        refuse(key, fmt::format("found {}, expected an integer from {} to {}", shown(*found), low, high));
    }
    const std::uint64_t value = found->get<std::uint64_t>();
    if (value < low || value > high) {
        refuse(key, fmt::format("found {}, expected an integer from {} to {}", value, low, high));
    }
    return true;
}

bool JsonPlace::index(std::string_view key, std::string_view collection, Need need) const {
    json* found = member(key, need);
    if (!found) {
        return false;
    }
    const std::size_t size = collection_size(file_->json, collection);
    if (!normalise_integer(*found) || found->get<std::uint64_t>() >= size) {
        refuse(key, fmt::format("found {}, {}", shown(*found), expected_index(size, collection)));
    }
    return true;
}

bool JsonPlace::indices(std::string_view key, std::string_view collection) const {
    json* found = member(key, Need::optional);
    if (!found) {
        return false;
    }
    if (!found->is_array()) {
        refuse(key, fmt::format("found {}, expected an array of indices of {}", shown(*found), collection));
    }
    const std::size_t size = collection_size(file_->json, collection);
    for (std::size_t i = 0; i < found->size(); ++i) {
        json& element = (*found)[i];
        if (!normalise_integer(element) || element.get<std::uint64_t>() >= size) {
            file_->refuse(fmt::format("{}/{}", pointer_to(key), i),
                          fmt::format("found {}, expected an index below {} (the number of {})",
                                      shown(element), size, collection));
        }
    }
    return true;
}

bool JsonPlace::object(std::string_view key, const std::function<void(const JsonPlace&)>& check,
                       Need need) const {
    json* found = member(key, need);
    if (found) {
        const JsonPlace place(*file_, *found, pointer_to(key));
        place.expect_object();
        check(place);
    }
    return found;
}

bool JsonPlace::objects(std::string_view key, const std::function<void(const JsonPlace&)>& check,
                        Need need) const {
    json* found = member(key, need);
    if (!found) {
        return false;
    }
    if (!found->is_array()) {
        refuse(key, fmt::format("found {}, expected an array of objects", shown(*found)));
    }
    for (std::size_t i = 0; i < found->size(); ++i) {
        const JsonPlace place(*file_, (*found)[i], fmt::format("{}/{}", pointer_to(key), i));
        place.expect_object();
        check(place);
    }
    return true;
}

std::uint64_t JsonPlace::get(std::string_view key, std::uint64_t fallback) const {
    const auto found = value_->find(key);
    return found == value_->end() ? fallback : found->get<std::uint64_t>();
}

}  // namespace lanthorn
