#include "engine/assets/gltf_document_state.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

using nlohmann::json;

void GltfDocument::State::refuse(std::string_view place, std::string_view problem) const {
    throw InputError(name, place, problem);
}

json GltfDocument::State::given_json(const std::string& place, std::string_view text) const {
    const std::optional<nlohmann::ordered_json> value = json_if_valid(text);
    if (!value) {
        refuse(place, fmt::format("found '{:.40}', expected JSON", text));
    }
    return json(*value);
}

std::size_t GltfDocument::State::count(std::string_view collection) const {
    const JsonText* array = root.find(collection);
    return array == nullptr ? 0 : array->size();
}

const JsonText& GltfDocument::State::element(std::string_view collection, std::size_t index) const {
    const std::size_t size = count(collection);
    if (index >= size) {
        refuse(
            fmt::format("/{}/{}", collection, index),
            fmt::format("found index {}, expected one below {} (the number of {})", index, size, collection));
    }
    return root.find(collection)->at(index);
}

JsonText& GltfDocument::State::element(std::string_view collection, std::size_t index) {
    return const_cast<JsonText&>(std::as_const(*this).element(collection, index));
}

JsonText& GltfDocument::State::lights() {
    JsonText& extension = object_at(object_at(root, "extensions"), "KHR_lights_punctual");
    JsonText* lights = extension.find("lights");
    return lights == nullptr ? extension.set("lights", JsonText("[]")) : *lights;
}

std::size_t GltfDocument::State::light_count() const {
    const JsonText* at = &root;
    for (const char* key : {"extensions", "KHR_lights_punctual", "lights"}) {
        at = at->find(key);
        if (at == nullptr) {
            return 0;
        }
    }
    return at->size();
}

std::size_t GltfDocument::State::append(std::string_view collection, JsonText value) {
    JsonText* array = root.find(collection);
    if (array == nullptr) {
        array = &root.set(collection, JsonText("[]"));
    }
    array->append(std::move(value));
    return array->size() - 1;
}

void GltfDocument::State::use_extension(std::string_view extension) {
    JsonText* used = root.find("extensionsUsed");
    if (used == nullptr || !used->is_array()) {
        used = &root.set("extensionsUsed", JsonText("[]"));
    }
    for (std::size_t i = 0; i < used->size(); ++i) {
        if (parsed(used->at(i)) == extension) {
            return;
        }
    }
    used->append(JsonText(json_quoted(extension)));
}

void GltfDocument::State::expect_in(double value, double low, double high, const std::string& place) const {
    if (!(value >= low && value <= high) || !std::isfinite(value)) {
        refuse(place, high < std::numeric_limits<float>::max()
                          ? fmt::format("found {:.7g}, expected {:.7g}..{:.7g}", value, low, high)
                          : fmt::format("found {:.7g}, expected a finite number from {:.7g}", value, low));
    }
}

json parsed(const JsonText& text) {
    return parse_json(text.text(), "document");
}

json parsed(const JsonText& object, std::string_view key) {
    const JsonText* member = object.find(key);
    return member == nullptr ? json() : parsed(*member);
}

std::uint64_t index_at(const JsonText& object, std::string_view key, std::uint64_t fallback) {
    const json value = parsed(object, key);
    return value.is_number() ? static_cast<std::uint64_t>(value.get<double>()) : fallback;
}

double plain_number(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    double result = 0;
    std::from_chars(text, end, result);
    return plain_number(result);
}

double plain_number(double value) {
    return value == 0 ? 0.0 : value;
}

namespace {

bool means_the_same(const json& a, const json& b, bool exact) {
    if (a.is_number() && b.is_number()) {
        const double x = a.get<double>();
        const double y = b.get<double>();
        return x == y || (!exact && static_cast<float>(x) == static_cast<float>(y));
    }
    if (!a.is_array() || !b.is_array() || a.size() != b.size()) {
        return a == b;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!means_the_same(a[i], b[i], exact)) {
            return false;
        }
    }
    return true;
}

}  // namespace

void patch(JsonText& object, std::string_view key, const json& value, const json& fallback, bool exact) {
    const JsonText* known = object.find(key);
    if (means_the_same(known == nullptr ? fallback : parsed(*known), value, exact)) {
        return;
    }
    object.set(key, JsonText(value.dump()));
}

JsonText& object_at(JsonText& object, std::string_view key) {
    JsonText* member = object.find(key);
    return member != nullptr && member->is_object() ? *member : object.set(key, JsonText("{}"));
}

}  // namespace lanthorn
