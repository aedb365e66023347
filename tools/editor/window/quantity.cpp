#include "tools/editor/window/quantity.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace lanthorn::edit_window {

namespace {

constexpr int kDeepest = 32;  // brackets

class Reader {
  public:
    explicit Reader(std::string_view text) : text_(text) {}

    std::optional<double> sum(int depth = 0) {
        std::optional<double> value = product(depth);
        while (value) {
            const char sign = peek();
            if (sign != '+' && sign != '-') {
                break;
            }
            ++at_;
            const auto next = product(depth);
            if (!next) {
                return std::nullopt;
            }
            *value += sign == '+' ? *next : -*next;
        }
        return value;
    }

    std::string unit() {
        peek();
        std::string letters;
        while (at_ < text_.size() && text_[at_] != ' ') {
            letters += text_[at_++];
        }
        peek();
        return letters;
    }
    bool ended() const { return at_ == text_.size(); }

  private:
    char peek() {
        while (at_ < text_.size() && text_[at_] == ' ') {
            ++at_;
        }
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    std::optional<double> product(int depth) {
        std::optional<double> value = factor(depth);
        while (value) {
            const char sign = peek();
            if (sign != '*' && sign != '/') {
                break;
            }
            ++at_;
            const auto next = factor(depth);
            if (!next) {
                return std::nullopt;
            }
            *value = sign == '*' ? *value * *next : *value / *next;
        }
        return value;
    }

    std::optional<double> factor(int depth) {
        const char first = peek();
        if (depth > kDeepest) {
            return std::nullopt;
        }
        if (first == '-' || first == '+') {
            ++at_;
            const auto value = factor(depth + 1);
            return value ? std::optional(first == '-' ? -*value : *value) : std::nullopt;
        }
        if (first == '(') {
            ++at_;
            const auto value = sum(depth + 1);
            if (!value || peek() != ')') {
                return std::nullopt;
            }
            ++at_;
            return value;
        }
        if (std::isdigit(static_cast<unsigned char>(first)) == 0 && first != '.') {
            return std::nullopt;
        }
        double value = 0;
        const auto [end, problem] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (problem != std::errc()) {
            return std::nullopt;
        }
        at_ = static_cast<std::size_t>(end - text_.data());
        return value;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<Quantity> typed_quantity(std::string_view text) {
    if (text.find_first_not_of(' ') != std::string_view::npos) {
        const std::string_view trimmed = text.substr(text.find_first_not_of(' '));
        if (trimmed.starts_with("inf")) {
            return Quantity{INFINITY, ""};
        }
    }
    Reader reader(text);
    const auto value = reader.sum();
    if (!value || !std::isfinite(*value)) {
        return std::nullopt;
    }
    Quantity result{*value, reader.unit()};
    const bool is_unit = result.unit.find_first_of("0123456789.+-*/()") == std::string::npos;
    return reader.ended() && is_unit ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<double> typed_number(std::string_view text, std::string_view unit) {
    const auto typed = typed_quantity(text);
    if (!typed) {
        return std::nullopt;
    }
    if (typed->unit.empty() || typed->unit == unit) {
        return typed->value;
    }
    const auto is = [&](std::string_view to, std::string_view from) {
        return unit == to && typed->unit == from;
    };
    constexpr double kDegree = std::numbers::pi / 180;
    const double factor = is("rad", "deg") || is("rad", "\u00b0") ? kDegree
                          : is("\u00b0", "rad")                   ? 1 / kDegree
                          : is("\u00b0", "deg")                   ? 1
                          : is("m", "mm")                         ? 1e-3
                          : is("m", "cm")                         ? 1e-2
                          : is("m", "km")                         ? 1e3
                          : is("K", "k") || is("lx", "lux")       ? 1
                                                                  : 0;
    return factor > 0 ? std::optional(typed->value * factor) : std::nullopt;
}

std::string shown_number(double value, int digits) {
    if (std::isinf(value)) {
        return value > 0 ? "infinite" : "-infinite";
    }
    if (std::abs(value) < 1e-12) {
        return "0";
    }
    // No exponent for what people type, and no more places than the digits.
    const double size = std::floor(std::log10(std::abs(value)));
    if (size >= 9 || size < -4) {
        return fmt::format("{:.{}g}", value, digits);
    }
    const int places = std::max(0, digits - 1 - static_cast<int>(size));
    std::string text = fmt::format("{:.{}f}", value, places);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') {
            text.pop_back();
        }
    }
    return text == "-0" ? "0" : text;
}

}  // namespace lanthorn::edit_window
