// The settings of every technique and of the reference.
#pragma once

#include "lanthorn/core/settings.h"

namespace lanthorn::workbench {

// Declares render.*, and gi.* and path.* of the techniques that this program has.
void declare_all_settings(SettingsSchema& schema);

// All at their defaults, but light is reflected gi.bounces times: of what is compared with references that
// count them. Set gi.gather.endless for more.
Settings counted_settings(const SettingsSchema& schema);

// The same, and light is scattered by diffuse reflections alone where `path` makes frames: of what measures
// irradiance in them. Set path.transport for more.
Settings measured_settings(const SettingsSchema& schema);

}  // namespace lanthorn::workbench
