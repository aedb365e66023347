// The parts that the game's levels are built of: closed solids with colliders, and nodes with the game's
// components (docs/levels.md). Metres; it stands on y = 0.
#pragma once

#include <string>
#include <vector>

#include "tools/scene_generator/level_finishes.h"

namespace lanthorn::scene_generator {

inline constexpr double kLevelWall = 0.3;  // thickness of outer walls

// Stands on `feet` and looks at `at`: her eyes, her body, and the camera that follows her.
void add_player(Builder& b, const dvec3& feet, const dvec3& at);

// Dark: bright metal so near a flame is a small lamp of its own, which few rays find, and walls and ceiling
// are blotched by those that do.
std::uint32_t bronze(Builder& b);
// A lantern of metal, glass panes left out, that stands on `foot`; `fields` of its component beside the
// handle, as JSON.
void add_lantern(Builder& b, std::uint32_t metal, const dvec3& foot, const vec3& colour, float candela,
                 const std::string& fields = {});

// Floor, ceiling and walls of a room that is 2 `half` wide inside, y from 0 to `half`.y. A wall of kNone is
// left out.
struct RoomWalls {
    std::uint32_t west, east, back, front;  // -X, +X, -Z, +Z
};
void add_room(Builder& b, const Finishes& f, const dvec3& half, const RoomWalls& walls);

// A spot light; angles of its cone in degrees from its middle.
void add_spot(Builder& b, const std::string& name, const dvec3& from, const dvec3& to, const vec3& colour,
              float candela, float inner, float outer);
inline constexpr vec3 kMoonlight{0.5f, 0.7f, 1};
inline constexpr vec3 kLamplight{1, 0.7f, 0.4f};

// A cluster of crystals on a round plate of slate with a rim of brass, of 0.5 m radius, at `place` on a wall
// that looks to `towards`. `sensor`: the fields of its light sensor but for the radius, `crystal`: of its
// crystal, as JSON. Awake, it lights what is around it.
void add_crystal(Builder& b, const Finishes& f, const std::string& name, const dvec3& place,
                 const dvec3& towards, const vec3& colour, const std::string& sensor,
                 const std::string& crystal);

// A mirror of 0.8 x 1.2 m, silvered on both sides, in a frame on a foot that turns while it is used.
// `degrees`: its normal's angle from +Z towards +X, at first; `speed` in radians a second.
void add_turning_mirror(Builder& b, const Finishes& f, std::uint32_t silver, const std::string& name,
                        const dvec3& foot, double degrees, double speed);

// An iron bracket on a wall that looks to `towards` (+Z, -Z, +X or -X), with a bowl in which a warm flame
// burns, a point light.
void add_sconce(Builder& b, const Finishes& f, const std::string& name, const dvec3& wall,
                const dvec3& towards, float candela);

// A point light at `place` below `parent`, and a flame of `height` metres around it.
void add_flame(Builder& b, const std::string& name, const dvec3& place, const vec3& colour, float candela,
               double height, std::uint32_t parent);

// A painted crate with rims of oak, a cube of `size` metres that stands on `foot` and can be shoved; `mass`
// in kilograms.
void add_crate(Builder& b, const Finishes& f, const std::string& name, const dvec3& foot, double size,
               std::uint32_t paint, double mass);

// What `lanthorn measure contracts` holds the level's light to, as the level begins: the fields of a
// light_contract, as JSON, in a box of `size` metres.
void add_contract(Builder& b, const std::string& name, const dvec3& centre, const dvec3& size,
                  const std::string& fields);

// What the level is called: the fields of {"level": {...}}.
void add_level(Builder& b, const std::string& fields);

// Skirting along the inside of a room from `low` to `high`, and a cornice below its ceiling.
void add_mouldings(Builder& b, const Finishes& f, const dvec3& low, const dvec3& high);
// Beams across the room along X or Z (`along`), `count` of them, below its ceiling. No camera comes between
// them.
void add_beams(Builder& b, const Finishes& f, const dvec3& low, const dvec3& high, bool along_x, int count);
// A pier with plinth and cap, `half` wide both ways.
void add_pier(Builder& b, const Finishes& f, const std::string& name, const dvec3& foot, double half,
              double height);

// A wall from `low` to `high` with an opening that is a hole through it along X or Z, whichever it is thinner
// in, from `hole_low` to `hole_high`; bars of iron stand in it if `bars` is more than 0. Nothing goes through
// a window, a hole above the floor, the camera neither; light does.
void add_wall_with_hole(Builder& b, const Finishes& f, const std::string& name, std::uint32_t material,
                        const dvec3& low, const dvec3& high, const dvec3& hole_low, const dvec3& hole_high,
                        int bars);

}  // namespace lanthorn::scene_generator
