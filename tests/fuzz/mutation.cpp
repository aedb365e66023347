#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace lanthorn {

using nlohmann::json;

namespace {

// Every value below `value`, itself included.
void collect(json& value, std::vector<json*>& all) {
    all.push_back(&value);
    if (value.is_structured()) {
        for (json& element : value) {
            collect(element, all);
        }
    }
}

}  // namespace

void Mutator::damage_bytes_once(std::string& bytes) {
    static constexpr std::array<std::uint32_t, 8> kWords = {
        0u, 1u, 0xffffffffu, 0x7fffffffu, 0x80000000u, 0x7fc00000u, 0x7f800000u, 0xff7fffffu};
    if (bytes.empty()) {
        return;
    }
    const std::size_t at = below(bytes.size());
    const std::size_t length = 1 + below(std::min<std::size_t>(16, bytes.size() - at));
    switch (below(6)) {
        case 0:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
            break;
        case 1:
            bytes[at] = static_cast<char>(below(256));
            break;
        case 2: {  // a number of interest: limits, NaN, infinity
            const std::uint32_t word = kWords[below(kWords.size())];
            std::memcpy(&bytes[at], &word, std::min<std::size_t>(sizeof word, bytes.size() - at));
            break;
        }
        case 3:
            bytes.erase(at, length);
            break;
        case 4:
            bytes.insert(at, bytes.substr(at, length));
            break;
        default:
            bytes.resize(at);
    }
}

void Mutator::damage_bytes(std::string& bytes) {
    for (std::size_t count = 1 + below(4); count > 0; --count) {
        damage_bytes_once(bytes);
    }
}

json Mutator::any_value() {
    switch (below(20)) {
        case 0:
            return nullptr;
        case 1:
            return true;
        case 2:
            return -1;
        case 3:
            return 0xffffffffu;
        case 4:
            return 0x80000000u;
        case 5:
            return 0xffffffffffffffffu;
        case 6:
            return 9007199254740993;
        case 7:
            return 1e300;
        case 8:
            return -3.4e38;
        case 9:
            return 1e-40;
        case 10:
            return 0.5;
        case 11:
            return "";
        case 12:
            return "data:application/octet-stream;base64,AAAA";
        case 13:
            return "%00/\n../x";
        case 14:
            return json::array();
        case 15:
            return json::object();
        case 16:
            return json::array({0, 0});
        default:
            return below(12);  // most often an index or a small number
    }
}

void Mutator::damage_json_once(json& root) {
    std::vector<json*> all;
    collect(root, all);
    json& victim = *all[below(all.size())];
    switch (below(6)) {
        case 0:
            if (victim.is_object() && !victim.empty()) {
                victim.erase(std::next(victim.begin(), static_cast<std::ptrdiff_t>(below(victim.size()))));
            } else if (victim.is_array() && !victim.empty()) {
                victim.erase(below(victim.size()));
            } else {
                victim = any_value();
            }
            break;
        case 1: {  // something else from the same document
            json other = *all[below(all.size())];
            victim = std::move(other);
            break;
        }
        case 2: {
            json copy = victim;
            json& other = *all[below(all.size())];
            if (other.is_array()) {
                other.push_back(std::move(copy));
            } else {
                victim = any_value();
            }
            break;
        }
        case 3:
            if (victim.is_number()) {
                static constexpr std::array<double, 6> kFactors = {-1, 0, 2, 0.5, 1e9, 1e-9};
                victim = victim.get<double>() * kFactors[below(kFactors.size())];
                break;
            }
            [[fallthrough]];
        default:
            victim = any_value();
    }
}

void Mutator::damage_json(json& root) {
    for (std::size_t count = 1 + below(3); count > 0; --count) {
        damage_json_once(root);
    }
}

}  // namespace lanthorn
