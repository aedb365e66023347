// What the game knows of the level's entities. Nodes of the level have these by their extras; docs/levels.md
// lists them.
//
// Declared field by field in components.cpp: what is declared is hashed, so that a replay is checked by it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/entity.h"
#include "lanthorn/scene/light.h"

namespace lanthorn::ecs {
class Registry;
class World;
}  // namespace lanthorn::ecs

namespace lanthorn::game {

struct Player {
    dvec3 velocity{0};       // that she walks at, metres a second
    std::uint32_t held = 0;  // Buttons down in the last step
    bool operator==(const Player&) const = default;

    static constexpr double kSpeed = 2.6;  // metres a second
};

// The camera that the player sees with; its node is below hers.
struct Eyes {
    double yaw = 0;    // radians; 0 looks along -Z, positive to the left
    double pitch = 0;  // radians, up
    bool operator==(const Eyes&) const = default;

    dvec3 facing() const;  // unit, level
};

// A leaf that turns about its node's +Y.
struct Door {
    double open_angle = 1.9;  // radians from where it stands in the file
    double angle = 0;         // radians
    double speed = 0;         // radians a second
    bool open = false;        // where it is going
    quat closed{1, 0, 0, 0};  // the node's rotation at angle 0
    bool operator==(const Door&) const = default;
};

// It can be carried, and hangs from the hand then; its node is below no other.
struct Lantern {
    double handle = 0.22;  // metres from its origin up to where it is held
    bool carried = false;
    bool lit = true;
    double yaw = 0;            // radians
    glm::dvec2 sway{0};        // radians: towards +X and +Z
    glm::dvec2 sway_speed{0};  // radians a second
    dvec3 hand{0};             // what it hangs from, last step
    dvec3 hand_velocity{0};    // metres a second
    double lift = 0;           // 0 to 1: of its way from where it was taken to the hand
    ecs::Entity flame;         // the node of its light; null: none
    Light light;               // of the flame when it is lit, at its brightest and through no glass

    std::vector<vec3> slides;            // coloured glasses that can be put in: what they let through
    std::uint32_t slide = 0;             // 0: none, else slides[slide - 1] is in
    std::uint32_t brightness = kLevels;  // 1 to kLevels, each twice the one before
    bool operator==(const Lantern&) const = default;

    quat rotation() const;
    Light shining() const;  // as it shines now

    static constexpr std::uint32_t kLevels = 4;
};

// A leaf that slides.
struct Shutter {
    dvec3 way{0, 1, 0};  // metres from where it stands in the file to where it is open, in its parent's axes
    double seconds = 1;  // that it takes
    double share = 0;    // of the way, 0 to 1
    bool open = false;   // where it is going
    dvec3 shut{0};       // the node's translation at share 0
    bool operator==(const Shutter&) const = default;
};

// Something that the player pushes to and fro along a rail.
struct Pushed {
    dvec3 rail{1, 0, 0};  // metres from where it stands in the file to the other end, in its parent's axes
    double share = 0;     // of the rail, 0 to 1
    dvec3 start{0};       // the node's translation at share 0
    bool operator==(const Pushed&) const = default;
};

// Something that turns about its node's +Y while the player uses it.
struct Turntable {
    double speed = 0.7;      // radians a second
    double angle = 0;        // radians from where it stands in the file
    quat start{1, 0, 0, 0};  // the node's rotation at angle 0
    bool operator==(const Turntable&) const = default;
};

// Reached once the light sensor of the same entity reads enough.
struct Goal {
    double lux = 2;
    bool reached = false;
    bool operator==(const Goal&) const = default;
};

// For those who cannot tell colours: what is drawn beside a crystal.
enum class Symbol : std::uint8_t { circle, triangle, square, star, moon, drop };

// Wakes once the light sensor of the same entity has read enough for long enough; then it stays awake. It
// glows as it wakes: its own material, and the light below it.
struct Crystal {
    double lux = 1;      // that are enough, through the sensor's filter
    double seconds = 1;  // of them that wake it; without them it falls back as fast
    Symbol symbol = Symbol::circle;
    vec3 glow{0};       // nits, awake, of its first mesh; of others as much less as their colour is darker
    double charge = 0;  // 0 to 1: how much has come together
    bool awake = false;
    double glowing = 0;  // 0 to 1: how much of its glow shows
    ecs::Entity lamp;    // the node of the light below it; null: none
    Light light;         // of the lamp, awake
    bool operator==(const Crystal&) const = default;
};

// What is pressed in a tour.
enum class Deed : std::uint8_t { none, use, light, carry, brighter, darker, colour };

// A leg of a tour: she walks and looks for so many seconds, and then does something.
struct Leg {
    dvec3 go{0};    // where to stand; its Y does not count
    dvec3 look{0};  // what to look at
    double seconds = 2;
    Deed deed = Deed::none;
    bool hold = false;  // the button is down all the while
    bool operator==(const Leg&) const = default;
};

// What a level is called, what helps in it, and how it is solved; one a level.
struct LevelInfo {
    std::string title;
    std::vector<std::string> hints;  // from the faintest to the plainest
    std::vector<Leg> tour;           // empty: the tour is made up from the first door and lantern
    bool operator==(const LevelInfo&) const = default;
};

// Whether every crystal is awake and every goal reached, and there are any.
bool solved(const ecs::World& world);
// The level's; an empty one where it has none.
LevelInfo level_info(const ecs::World& world);

void declare_components(ecs::Registry& registry);
// LevelInfo alone, and what it is made of; declare_components() has it too.
void declare_level_info(ecs::Registry& registry);

}  // namespace lanthorn::game
