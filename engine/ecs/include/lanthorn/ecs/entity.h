// Entity: a handle to a row of components. The generation tells a reused index from its former owner, so that
// a stale handle is a checked error and never somebody else's data.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace lanthorn::ecs {

struct Entity {
    std::uint32_t index = 0xffffffffu;
    std::uint32_t generation = 0;  // 0 only in the null entity

    auto operator<=>(const Entity&) const = default;
    // False for the null entity (the default); says nothing about being alive: that is World::alive.
    explicit operator bool() const { return generation != 0; }
    // One number an entity; of the null entity 0xffffffff.
    std::uint64_t bits() const { return std::uint64_t{generation} << 32 | index; }
};

inline constexpr Entity kNullEntity{};

// "entity 12v3" (index 12, generation 3) or "entity null".
inline std::string to_string(Entity e) {
    return e ? "entity " + std::to_string(e.index) + "v" + std::to_string(e.generation) : "entity null";
}

// Points in the history of a World: everything written at a tick greater than `since` changed since then.
// 0 is before everything.
using Tick = std::uint64_t;

}  // namespace lanthorn::ecs

// For unordered containers: multiplied by 2^64 / the golden ratio (Knuth's multiplicative hashing).
template <>
struct std::hash<lanthorn::ecs::Entity> {
    std::size_t operator()(lanthorn::ecs::Entity e) const noexcept {
        return std::hash<std::uint64_t>()(e.bits() * 0x9e3779b97f4a7c15ull);
    }
};
