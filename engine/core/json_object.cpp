#include "lanthorn/core/json_object.h"

#include <fmt/format.h>

#include "lanthorn/core/error.h"

namespace lanthorn {

nlohmann::json parse_json_object(std::string_view text, std::string_view source, std::string_view what) {
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
