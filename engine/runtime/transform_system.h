// World transforms as a system, wherever something has moved.
#pragma once

#include <string>

#include "lanthorn/runtime/app.h"

namespace lanthorn {

// Adds a system that brings WorldTransforms up to date by the resource Transforms.
ecs::Schedule::Config add_transforms(App& app, ecs::Schedule& schedule, std::string name);

}  // namespace lanthorn
