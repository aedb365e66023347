// JSON that is edited as text: what an edit does not touch keeps its bytes - numbers, escapes, order, white
// space.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lanthorn {

// A JSON value (RFC 8259). It is taken apart only where it is looked into, one level at a time, and put
// together again from the same pieces of text. Looking into a value also stores the pieces, so even const
// functions are for one thread at a time. References to parts hold until a part of the same container is
// added or erased.
class JsonText {
  public:
    // `text` must be one valid JSON value, without white space around it.
    explicit JsonText(std::string text);

    bool is_object() const { return text_.front() == '{'; }
    bool is_array() const { return text_.front() == '['; }
    bool is_string() const { return text_.front() == '"'; }

    // Members of an object or elements of an array; 0 for other values.
    std::size_t size() const;
    JsonText& at(std::size_t index);
    const JsonText& at(std::size_t index) const;
    std::string key(std::size_t index) const;  // of a member, without quotes and escapes

    // The member of that name, the last one where there are several (as parsers take it); nullptr if there is
    // none or the value is no object.
    JsonText* find(std::string_view key);
    const JsonText* find(std::string_view key) const;

    // Replaces the member in its place or adds it at the end, laid out as its neighbour is. Returns it.
    // Throws InputError for a key that is not UTF-8.
    JsonText& set(std::string_view key, JsonText value);
    void append(JsonText value);       // to an array
    bool erase(std::string_view key);  // all members of that name; whether there was one
    void erase(std::size_t index);

    // The text as it is now. O(its size).
    std::string text() const;

  private:
    struct Part {
        std::string_view before;   // white space ahead of the key or element
        std::string key;           // as written, with its quotes; empty in arrays
        std::string_view between;  // ":" and white space
        std::unique_ptr<JsonText> value;
        std::string_view after;  // white space behind the value
        Part clone() const;
    };

    JsonText(std::shared_ptr<const std::string> source, std::string_view text)
        : source_(std::move(source)), text_(text) {}
    void take_apart() const;
    void append_to(std::string& out) const;
    void add(std::string key, JsonText value);
    std::size_t index_of(std::string_view key) const;

    std::shared_ptr<const std::string> source_;  // what text_ and the parts' views point into
    std::string_view text_;                      // the value before any edit
    mutable bool apart_ = false;
    mutable std::vector<Part> parts_;  // while apart_
    mutable std::string_view inside_;  // what an empty container holds: white space

  public:
    JsonText(const JsonText& other);
    JsonText(JsonText&&) noexcept = default;
    JsonText& operator=(const JsonText& other);
    JsonText& operator=(JsonText&&) noexcept = default;
    ~JsonText() = default;
};

// `text` as a JSON string, with quotes. Throws InputError if it is not UTF-8.
std::string json_quoted(std::string_view text);

}  // namespace lanthorn
