// Components of every kind that the storage must carry.
#pragma once

#include <memory>
#include <string>

namespace ecs_test {

struct Position {
    float x = 0, y = 0, z = 0;
    bool operator==(const Position&) const = default;
};
struct Velocity {
    float x = 0, y = 0, z = 0;
    bool operator==(const Velocity&) const = default;
};
struct Mass {
    double kg = 1;
};
struct Frozen {};
struct Enemy {};
struct Label {
    std::string text;
};
struct alignas(128) Wide {
    float lanes[32] = {};
};
struct Owner {
    std::unique_ptr<int> value;
};
// Counts living objects; its move may throw as far as the compiler knows, and it cannot be assigned.
struct Counted {
    static inline int living = 0;
    const int id;
    explicit Counted(int i) : id(i) { ++living; }
    Counted(Counted&& other) noexcept(false) : id(other.id) { ++living; }
    Counted& operator=(Counted&&) = delete;
    ~Counted() { --living; }
};

}  // namespace ecs_test
