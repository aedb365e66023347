#include "engine/assets/json_text.h"

#include <cassert>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

constexpr std::size_t kAbsent = ~std::size_t{0};

// Reads along text that is known to be valid JSON.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    char next() const { return text_[at_]; }
    std::string_view take(std::size_t count) {
        at_ += count;
        return text_.substr(at_ - count, count);
    }
    std::string_view white() {
        const std::size_t end = text_.find_first_not_of(" \t\r\n", at_);
        return take((end == std::string_view::npos ? text_.size() : end) - at_);
    }
    std::string_view string() {
        std::size_t end = at_ + 1;
        while (text_[end] != '"') {
            end += text_[end] == '\\' ? 2 : 1;
        }
        return take(end + 1 - at_);
    }
    std::string_view value() {
        if (next() == '"') {
            return string();
        }
        if (next() != '{' && next() != '[') {
            const std::size_t end = text_.find_first_of(" \t\r\n,]}", at_);
            return take((end == std::string_view::npos ? text_.size() : end) - at_);
        }
        const std::size_t begin = at_;
        int depth = 0;
        do {
            if (next() == '"') {
                string();
                continue;
            }
            depth += next() == '{' || next() == '[' ? 1 : next() == '}' || next() == ']' ? -1 : 0;
            ++at_;
        } while (depth > 0);
        return text_.substr(begin, at_ - begin);
    }

  private:
    std::string_view text_;
    std::size_t at_ = 0;
};

bool is_named(const std::string& quoted, std::string_view name) {
    if (quoted.find('\\') == std::string::npos) {
        return std::string_view(quoted).substr(1, quoted.size() - 2) == name;
    }
    return parse_json(quoted, "key").get_ref<const std::string&>() == name;
}

}  // namespace

JsonText::JsonText(std::string text)
    : source_(std::make_shared<const std::string>(std::move(text))), text_(*source_) {
    assert(!text_.empty());
}

JsonText::Part JsonText::Part::clone() const {
    return {before, key, between, std::make_unique<JsonText>(*value), after};
}

JsonText::JsonText(const JsonText& other)
    : source_(other.source_), text_(other.text_), apart_(other.apart_), inside_(other.inside_) {
    parts_.reserve(other.parts_.size());
    for (const Part& part : other.parts_) {
        parts_.push_back(part.clone());
    }
}

JsonText& JsonText::operator=(const JsonText& other) {
    return *this = JsonText(other);
}

void JsonText::take_apart() const {
    if (apart_) {
        return;
    }
    apart_ = true;
    if (!is_object() && !is_array()) {
        return;
    }
    Scanner scanner(text_);
    scanner.take(1);
    std::string_view white = scanner.white();
    if (scanner.next() == '}' || scanner.next() == ']') {
        inside_ = white;
        return;
    }
    while (true) {
        Part part;
        part.before = white;
        if (is_object()) {
            part.key = scanner.string();
            const std::string_view gap = scanner.white();
            const std::string_view colon = scanner.take(1);
            const std::string_view rest = scanner.white();
            part.between = {gap.data(), gap.size() + colon.size() + rest.size()};
        }
        part.value.reset(new JsonText(source_, scanner.value()));
        part.after = scanner.white();
        parts_.push_back(std::move(part));
        if (scanner.take(1) != ",") {
            return;
        }
        white = scanner.white();
    }
}

std::size_t JsonText::size() const {
    take_apart();
    return parts_.size();
}

JsonText& JsonText::at(std::size_t index) {
    take_apart();
    return *parts_.at(index).value;
}

const JsonText& JsonText::at(std::size_t index) const {
    take_apart();
    return *parts_.at(index).value;
}

std::string JsonText::key(std::size_t index) const {
    take_apart();
    return parse_json(parts_.at(index).key, "key").get<std::string>();
}

std::size_t JsonText::index_of(std::string_view key) const {
    take_apart();
    for (std::size_t i = is_object() ? parts_.size() : 0; i-- > 0;) {
        if (is_named(parts_[i].key, key)) {
            return i;
        }
    }
    return kAbsent;
}

JsonText* JsonText::find(std::string_view key) {
    const std::size_t index = index_of(key);
    return index == kAbsent ? nullptr : parts_[index].value.get();
}

const JsonText* JsonText::find(std::string_view key) const {
    const std::size_t index = index_of(key);
    return index == kAbsent ? nullptr : parts_[index].value.get();
}

void JsonText::add(std::string key, JsonText value) {
    Part part;
    part.between = key.empty() ? "" : ":";
    part.key = std::move(key);
    part.value = std::make_unique<JsonText>(std::move(value));
    if (parts_.empty()) {
        part.after = inside_;
    } else {
        Part& last = parts_.back();
        const bool is_spaced = last.between.ends_with(' ') && parts_.size() == 1 && last.before.empty();
        part.before = is_spaced ? " " : last.before;  // the first member stands close to its bracket
        part.between = last.between;
        part.after = std::exchange(last.after, {});
    }
    parts_.push_back(std::move(part));
}

JsonText& JsonText::set(std::string_view key, JsonText value) {
    assert(is_object());
    if (JsonText* known = find(key)) {
        *known = std::move(value);
        return *known;
    }
    add(json_quoted(key), std::move(value));
    return *parts_.back().value;
}

void JsonText::append(JsonText value) {
    assert(is_array());
    take_apart();
    add({}, std::move(value));
}

bool JsonText::erase(std::string_view key) {
    bool erased = false;
    for (std::size_t index = index_of(key); index != kAbsent; index = index_of(key)) {
        erase(index);
        erased = true;
    }
    return erased;
}

void JsonText::erase(std::size_t index) {
    take_apart();
    const bool was_last = index + 1 == parts_.size();
    const std::string_view before = parts_.at(index).before;
    const std::string_view after = parts_.at(index).after;
    parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(index));
    if (parts_.empty()) {
        inside_ = after;
    } else if (was_last) {
        parts_.back().after = after;
    } else if (index == 0) {
        parts_.front().before = before;
    }
}

void JsonText::append_to(std::string& out) const {
    if (!apart_ || (!is_object() && !is_array())) {
        out += text_;
        return;
    }
    out += text_.front();
    out += parts_.empty() ? inside_ : std::string_view();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = parts_[i];
        out += i > 0 ? "," : "";
        out += part.before;
        out += part.key;
        out += part.between;
        part.value->append_to(out);
        out += part.after;
    }
    out += text_.back();
}

std::string JsonText::text() const {
    std::string out;
    out.reserve(text_.size());
    append_to(out);
    return out;
}

std::string json_quoted(std::string_view text) {
    try {
        return nlohmann::json(text).dump();
    } catch (const nlohmann::json::exception&) {
        throw InputError("found a name that is not UTF-8, expected UTF-8 text");
    }
}

}  // namespace lanthorn
