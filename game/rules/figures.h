// Figures that walk: the hero's body, her hand, the camera behind her, a puppet that follows. Levels have
// them by their extras, as all of components.h.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/entity.h"

namespace lanthorn::ecs {
class Registry;
}  // namespace lanthorn::ecs

namespace lanthorn::game {

// A skinned figure that faces its node's +Z and stands and walks by two clips of its file, blended by how
// fast its node comes along. Below the player it is her body.
struct Figure {
    std::string idle, walk;  // clips
    double stride = 1.3;     // metres that a round of `walk` covers
    double yaw = 0;          // radians; 0 faces -Z, positive to the left
    bool turning = false;    // on the spot
    dvec3 place{0};          // metres, of its node in the last step
    dvec3 velocity{0};       // metres a second
    double pace = 0;         // metres a second that it walks at; negative: backwards
    double walking = 0;      // 0 to 1: how much of `walk` shows
    bool operator==(const Figure&) const = default;
};

// What a lantern is carried by: a node below the hand's joint of a Figure. The arm has clips of its own,
// which move nothing else.
struct Hand {
    std::string idle, walk;        // with the figure's
    std::string reach, close;      // that hold a lantern out, and near the body where there is no room
    dvec3 out{-0.24, 1.36, 0.48};  // metres from the figure's feet, in its axes: where `reach` has it
    double carrying = 0;           // 0 to 1
    double room = 1;               // 0 to 1: of the way out
    ecs::Entity figure;            // the Figure above it
    bool operator==(const Hand&) const = default;
};

// A camera that looks where the player looks, from behind her or with her eyes.
struct FollowCamera {
    double distance = 2.3;  // metres behind her, where there is room
    double aside = 0.42;    // metres to the right, or to the left where there is more room
    double above = 0.12;    // metres
    double ahead = 0.21;    // metres that it is before her axis as her eyes, so that her head is behind it
    bool first_person = false;
    double side = 1;              // over which shoulder it looks: 1 right, 0 neither, -1 left
    double beside = 0, back = 0;  // metres, as it is
    bool operator==(const FollowCamera&) const = default;
};

// Comes after the player, in her footsteps where something is between them, and waits when it is near. It
// walks on floors, round what has a collider, and is in nobody's way. Its node is below no other.
struct Follower {
    double near = 1.3;     // metres from the player at which it stops,
    double far = 2.2;      // and from which on it follows
    double speed = 1.9;    // metres a second
    double radius = 0.18;  // metres
    bool follows = false;
    dvec3 velocity{0};         // metres a second
    std::vector<dvec3> trail;  // where the player walked since it saw her, the oldest first
    bool operator==(const Follower&) const = default;
};

// A follower that waits where it is told to, and comes when it is told to.
struct Heeds {
    bool waits = false;
    bool operator==(const Heeds&) const = default;
};

void declare_figures(ecs::Registry& registry);

}  // namespace lanthorn::game
