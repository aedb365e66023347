#include "engine/replay/header_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn::replay {

namespace {

template <class T>
const char* expectation() {
    return std::is_same_v<T, std::string>                  ? "a string"
           : std::is_arithmetic_v<T>                       ? "a number"
           : std::is_same_v<T, std::vector<std::uint64_t>> ? "a list of numbers"
                                                           : "a list of strings";
}

template <class T>
void read_member(const nlohmann::json& j, const char* name, T& to, const std::string& path) {
    const std::string place = std::string("header: ") + name;
    const auto found = j.is_object() ? j.find(name) : j.end();
    if (found == j.end()) {
        throw InputError(path, place, fmt::format("is missing, expected {}", expectation<T>()));
    }
    try {
        found->get_to(to);
    } catch (const nlohmann::json::exception&) {
        throw InputError(path, place,
                         fmt::format("found {:.60}, expected {}",
                                     found->dump(-1, ' ', true, nlohmann::json::error_handler_t::replace),
                                     expectation<T>()));
    }
}

}  // namespace

std::string header_text(const RecordingHeader& h) {
    const nlohmann::json json{
        {"level", h.level},           {"level_hash", h.level_hash}, {"seed", h.seed},
        {"step_rate", h.step_rate},   {"build", h.build},           {"input_format", h.input_format},
        {"input_size", h.input_size}, {"parts", h.parts},           {"schemas", h.schemas},
        {"sensors", h.sensors}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

RecordingHeader header_from_text(std::string_view text, const std::string& path, std::uint32_t version) {
    const nlohmann::json j = parse_json(text, path + ": header");
    RecordingHeader h;
    read_member(j, "level", h.level, path);
    read_member(j, "level_hash", h.level_hash, path);
    read_member(j, "seed", h.seed, path);
    read_member(j, "step_rate", h.step_rate, path);
    read_member(j, "build", h.build, path);
    read_member(j, "input_format", h.input_format, path);
    read_member(j, "input_size", h.input_size, path);
    read_member(j, "parts", h.parts, path);
    if (version > 2) {
        read_member(j, "schemas", h.schemas, path);
    } else {
        h.schemas.assign(h.parts.size(), 0);
    }
    read_member(j, "sensors", h.sensors, path);
    if (!(h.step_rate > 0) || !std::isfinite(h.step_rate)) {
        throw InputError(path, "header: step_rate",
                         fmt::format("found {}, expected more than 0", h.step_rate));
    }
    if (h.parts.size() > kMostParts || h.schemas.size() != h.parts.size()) {
        throw InputError(path, "header: parts",
                         fmt::format("found {} parts and {} schemas, expected as many of both, at most {}",
                                     h.parts.size(), h.schemas.size(), kMostParts));
    }
    return h;
}

}  // namespace lanthorn::replay
