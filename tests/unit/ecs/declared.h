// Components that the tests declare.
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/ecs/registry.h"

namespace lanthorn::ecs::test {

enum class Swing { inward, outward };

struct Hinge {
    dvec3 at{0};
    vec3 axis{0, 1, 0};
};

struct Door {
    float open_angle = 1.9f;
    float angle = 0;
    Swing swing = Swing::inward;
    bool open = false;  // padding follows
    Entity keeper;
    std::optional<dvec3> size;
    std::vector<std::string> tags;
    Hinge hinge;
    int drawn = 0;
};

struct Keys {
    std::vector<Entity> opens;
    std::uint64_t number = 0;
};

struct Clock {
    std::uint64_t step = 0;
};

inline void declare(Registry& registry) {
    registry.structure("hinge", field("at", &Hinge::at).unit("m"), field("axis", &Hinge::axis).range(-1, 1));
    registry.component<Door>(
        "door", "a leaf that turns",
        field("open_angle", &Door::open_angle).unit("rad").range(0, 3.1).words("how far it opens"),
        field("angle", &Door::angle).unit("rad").runtime().words("how far it is open"),
        field("swing", &Door::swing).choices({"inward", "outward"}), field("open", &Door::open),
        field("keeper", &Door::keeper), field("size", &Door::size).unit("m").more_than(0),
        field("tags", &Door::tags), field("hinge", &Door::hinge), field("drawn", &Door::drawn).transient());
    registry.component<Keys>("keys", "what they open", field("opens", &Keys::opens),
                             field("number", &Keys::number));
    registry.resource<Clock>("clock", "steps since the start", field("step", &Clock::step));
}

// What the exception says that `act` throws; empty if it throws none.
template <class Act>
std::string line_of(const Act& act) {
    try {
        act();
    } catch (const std::exception& e) {
        return e.what();
    }
    return "";
}

}  // namespace lanthorn::ecs::test
