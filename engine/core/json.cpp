#include "engine/core/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

// The byte at which `text` nests too deep. O(bytes).
std::optional<std::size_t> nests_too_deep(std::string_view text) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') {
                ++i;
            } else if (c == '"') {
                in_string = false;
            }
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kDeepestJson) {
                return i;
            }
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return std::nullopt;
}

std::string place_of(std::string_view text, std::size_t at) {
    const std::string_view before = text.substr(0, at);
    return fmt::format("JSON line {}, column {}", 1 + std::count(before.begin(), before.end(), '\n'),
                       before.size() - (before.rfind('\n') + 1) + 1);
}

// Where the number stands that nlohmann's message quotes.
std::string place_of_number(std::string_view text, std::string_view message) {
    const std::size_t open = message.find('\'');
    const std::size_t close = message.rfind('\'');
    const std::size_t at =
        open < close ? text.find(message.substr(open + 1, close - open - 1)) : std::string_view::npos;
    return at == std::string_view::npos ? "JSON" : place_of(text, at);
}

// nlohmann's message without "[json.exception...] parse error at line 1, column 2: ".
std::string tidy(std::string message) {
    for (const char* end : {"] ", "column "}) {
        if (const std::size_t found = message.find(end); found != std::string::npos) {
            message.erase(0, found + std::string_view(end).size());
        }
    }
    const std::size_t digits = message.find_first_not_of("0123456789");
    return digits > 0 && message.compare(digits, 2, ": ") == 0 ? message.substr(digits + 2) : message;
}

template <class Json>
Json parse(std::string_view text, std::string_view source) {
    if (const std::optional<std::size_t> at = nests_too_deep(text)) {
        throw InputError(source, place_of(text, *at),
                         fmt::format("found nesting deeper than {} levels", kDeepestJson));
    }
    try {
        return Json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        const std::size_t at = std::min(text.size(), std::max<std::size_t>(error.byte, 1) - 1);
        throw InputError(source, place_of(text, at), "is not JSON: " + tidy(error.what()));
    } catch (const nlohmann::json::out_of_range& error) {
        throw InputError(source, place_of_number(text, error.what()), tidy(error.what()));
    }
}

}  // namespace

nlohmann::json parse_json(std::string_view text, std::string_view source) {
    return parse<nlohmann::json>(text, source);
}

nlohmann::ordered_json parse_ordered_json(std::string_view text, std::string_view source) {
    return parse<nlohmann::ordered_json>(text, source);
}

nlohmann::json parse_json_object(std::string_view text, std::string_view source, std::string_view what) {
    nlohmann::json root = parse_json(text, source);
    if (!root.is_object()) {
        throw InputError(source, "",
                         fmt::format("found {}, expected an object of {}", root.type_name(), what));
    }
    return root;
}

std::optional<nlohmann::ordered_json> json_if_valid(std::string_view text) {
    try {
        return parse_ordered_json(text, "");
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace lanthorn
