// Actions as data: what a person can do in a program. A program declares a table of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace lanthorn::input {

// When an action counts.
enum class Kind : std::uint8_t {
    held,     // counts while it is down, as walking does
    pressed,  // begins with a press: what is down since before play went on does not count
    always,   // never reaches a step; works whether or not the program plays
    menu,     // the same, and always has a trigger: without a way there nothing could be bound anew
};

// Whether Step can hold it, and so a recording; the others are asked for between steps.
constexpr bool reaches_steps(Kind kind) {
    return kind == Kind::held || kind == Kind::pressed;
}

// A row of the table.
struct Action {
    const char* name;      // in files; no other row's
    const char* words;     // for people
    const char* triggers;  // unless told otherwise: names with ", " between them, "E, Pad A"; "": none
    Kind kind = Kind::pressed;
    // The program's own: its bit in a recorded input, say. Step::marks unites those that are down.
    std::uint32_t mark = 0;
};

// At most as many in a table.
inline constexpr std::size_t kMostActions = 64;

// A row's number, also made from a program's own enum whose values follow the table.
class ActionId {
  public:
    constexpr ActionId(std::size_t row) : row_(row) {}
    template <class Enum>
    requires std::is_enum_v<Enum>
    constexpr ActionId(Enum action) : row_(static_cast<std::size_t>(action)) {}
    constexpr std::size_t row() const { return row_; }  // counted from 0
    bool operator==(const ActionId&) const = default;

  private:
    std::size_t row_;
};

}  // namespace lanthorn::input
