#include "engine/core/json_object.h"

#include <fmt/format.h>

#include "lanthorn/core/error.h"

namespace lanthorn {

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

void check_nesting(std::string_view text, std::string_view source, std::string_view place) {
    if (const std::optional<std::size_t> at = nests_too_deep(text)) {
        throw InputError(source, fmt::format("{} {}", place, *at),
                         fmt::format("found nesting deeper than {} levels", kDeepestJson));
    }
}

nlohmann::json parse_json_object(std::string_view text, std::string_view source, std::string_view what) {
    check_nesting(text, source, "byte");
    nlohmann::json root;
    try {
        root = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        throw InputError(source, fmt::format("byte {}", error.byte), "is not JSON");
    } catch (const nlohmann::json::out_of_range& error) {
        throw InputError(source, "", fmt::format("is JSON with a number too large: {}", error.what()));
    }
    if (!root.is_object()) {
        throw InputError(source, "",
                         fmt::format("found {}, expected an object of {}", root.type_name(), what));
    }
    return root;
}

}  // namespace lanthorn
