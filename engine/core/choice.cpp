#include "lanthorn/core/choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <limits>

#include "lanthorn/core/error.h"

namespace lanthorn {

std::optional<std::size_t> find_by_name_or_number(std::span<const std::string> names,
                                                  const std::string& wanted) {
    const auto named = std::find(names.begin(), names.end(), wanted);
    if (named != names.end()) {
        return static_cast<std::size_t>(named - names.begin());
    }
    std::size_t number = 0;
    const char* last = wanted.data() + wanted.size();
    const auto [end, error] = std::from_chars(wanted.data(), last, number);
    if (error == std::errc() && end == last && number < names.size()) {
        return number;
    }
    return std::nullopt;
}

std::string numbered_names(std::span<const std::string> names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        text += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, names[i]);
    }
    return text;
}

ivec2 parse_size(const std::string& option, const std::string& text, int smallest, int largest) {
    ivec2 size{0};
    int read = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &size.x, &size.y, &read) != 2 ||
        static_cast<std::size_t>(read) != text.size() || std::min(size.x, size.y) < smallest ||
        std::max(size.x, size.y) > largest) {
        throw InputError(fmt::format("{}: found '{}', expected WIDTHxHEIGHT from {}x{} to {}x{}", option,
                                     text, smallest, smallest, largest, largest));
    }
    return size;
}

std::uint64_t parse_whole(const std::string& option, const std::string& text) {
    std::uint64_t number = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc() || end != last) {
        throw InputError(fmt::format("{}: found '{}', expected a whole number from 0 to {}", option, text,
                                     std::numeric_limits<std::uint64_t>::max()));
    }
    return number;
}

}  // namespace lanthorn
