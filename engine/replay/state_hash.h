// Hashes of simulation state: equal state gives equal hashes on the same build, and a difference says where
// it is.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::replay {

// xxHash (XXH3, 64 bits).
std::uint64_t hash_bytes(std::span<const std::byte> bytes);

// The hash of a file's bytes. Throws InputError if it cannot be read.
std::uint64_t hash_file(const std::string& path);

// Collects values field by field, so that padding never counts. Floats count by their bits: -0 differs from
// +0.
class StateHash {
  public:
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void add(const vec2& v) { add_all(v.x, v.y); }
    void add(const vec3& v) { add_all(v.x, v.y, v.z); }
    void add(const vec4& v) { add_all(v.x, v.y, v.z, v.w); }
    void add(const dvec3& v) { add_all(v.x, v.y, v.z); }
    void add(const quat& q) { add_all(q.w, q.x, q.y, q.z); }
    void add(ecs::Entity e) { add(e.bits()); }
    void add(const std::string& text) {
        add(std::uint64_t{text.size()});
        bytes_ += text;
    }
    template <class... Ts>
    void add_all(const Ts&... values) {
        (add(values), ...);
    }

    std::uint64_t value() const { return hash_bytes(std::as_bytes(std::span(bytes_))); }

  private:
    std::string bytes_;
};

// Which components of a world make up its state, each a named part with a hash of its own.
//
//   WorldHasher hasher;
//   hasher.component<Door>("door", [](StateHash& h, const Door& d) { h.add_all(d.angle, d.open); });
//   std::vector<std::uint64_t> hashes = hasher.hash(world);
class WorldHasher {
  public:
    // All entities with a T, in the order of their indices; `add` puts one T's fields into the hash.
    template <ecs::Component T, class Add>
    requires std::invocable<const Add&, StateHash&, const T&>
    void component(std::string name, Add add) {
        part(std::move(name), [add = std::move(add)](StateHash& hash, const ecs::World& world) {
            std::vector<std::pair<ecs::Entity, const T*>> all;
            world.query<ecs::Read<T>>().each(
                [&](ecs::Entity e, const T& value) { all.emplace_back(e, &value); });
            std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
            for (const auto& [entity, value] : all) {
                hash.add(entity);
                add(hash, *value);
            }
        });
    }
    // Anything else: a resource, the count of entities.
    void part(std::string name, std::function<void(StateHash&, const ecs::World&)> add);

    const std::vector<std::string>& names() const { return names_; }
    // One hash a part, in the order of their declaration. O(n log n) in the entities hashed.
    std::vector<std::uint64_t> hash(const ecs::World& world) const;

  private:
    std::vector<std::string> names_;
    std::vector<std::function<void(StateHash&, const ecs::World&)>> parts_;
};

}  // namespace lanthorn::replay
