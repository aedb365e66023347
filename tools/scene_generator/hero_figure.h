// Figures that the game moves: they stand at their node, facing +Z, with a clip to stand and one to walk on
// the spot (game/rules/figures.h).
#pragma once

#include "tools/scene_generator/builder.h"

namespace lanthorn::scene_generator {

// The hero below the player's node: her body, the hand that carries lanterns, and the camera that follows
// her.
void add_hero(Builder& b, std::uint32_t player);

// A puppet, 0.95 m high, that stands on `feet` and follows the player.
void add_follower(Builder& b, const std::string& name, const dvec3& feet);

// The same with a lantern on a staff, a point light: it waits on `feet` until it is told to come.
void add_lamp_bearer(Builder& b, const std::string& name, const dvec3& feet, const vec3& colour,
                     float candela);

}  // namespace lanthorn::scene_generator
