// Which views a frame is drawn for, and the FrameScene of each.
#pragma once

#include <memory>

#include "lanthorn/ecs/world.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn {

// Makes Renderer::views those that are to be drawn now, each with its FrameScene; frees what belonged to
// others. A view that was not drawn in the last frame starts without history: to it, everything has changed;
// but for one that rested (View::rests).
void follow_views(const ecs::World& world, const FrameScene& scene, Renderer& renderer);

}  // namespace lanthorn
