// Numbers as messages and JSON show them.
#pragma once

#include <charconv>
#include <string>

namespace lanthorn::ecs {

// The shortest decimal that is read back as the same number: 0.1, 3, 1e+30.
inline std::string number_text(double number) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, number);
    return {text, end.ptr};
}

// The double with the same shortest decimal as the float: 0.1f is 0.1.
inline double shortest(float number) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, number);
    double result = number;
    std::from_chars(text, end.ptr, result);
    return result;
}

}  // namespace lanthorn::ecs
