// What the picture alone shows otherwise than it is: figures are covered with a fuzz that shines along their
// outlines; what hides the player fades, as she does herself right before the camera, which looks down on her
// there. Light, shadows and the simulation know nothing of it.
#pragma once

#include <map>

#include "lanthorn/ecs/entity.h"
#include "lanthorn/render/picture_only.h"

namespace lanthorn::game {

// How much is seen of what is not seen whole (resource); by the frames before.
struct Fading {
    std::map<ecs::Entity, float> shown;  // share, by entity with meshes
    double moment = 0;                   // seconds since the start, that the frame before showed
};

// Share of the player that is seen with a camera so many metres from her eyes.
float shown_from(double metres);
// What comes of a share on its way to `wanted`, so many seconds after the frame before: it takes a quarter of
// a second from 0 to 1, and no time where that is no frame after another.
float faded(float now, float wanted, double seconds);

}  // namespace lanthorn::game
