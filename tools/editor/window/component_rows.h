// Rows of a component's fields, made from its declaration alone.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "tools/editor/window/value_field.h"

namespace lanthorn::edit_window {

// What a row says has been done: a field's path ("door.open_angle"), its value as the command `set` takes it.
using SetField = std::function<void(Doing doing, const std::string& field, const std::string& value)>;

// The author's fields of `type`, of several values of it (one a thing that is chosen, never null): where they
// differ a row says "mixed". Numbers of rad are shown in degrees.
void draw_component(ValueFields& fields, const ecs::ComponentType& type, std::span<const void* const> values,
                    const SetField& set);

}  // namespace lanthorn::edit_window
