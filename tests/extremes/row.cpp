#include "tests/extremes/row.h"

#include <cctype>

namespace lanthorn::extremes {

std::string plain(const std::string& name) {
    std::string result;
    for (const char c : name) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        result += is_plain ? c : c == '-' ? 'm' : '_';  // 1e-04 is not 1e+04
    }
    return result;
}

}  // namespace lanthorn::extremes
