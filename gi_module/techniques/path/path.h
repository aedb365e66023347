// `path`: the reference (lanthorn/reference/path_tracer.h), a frame at a time.
#pragma once

#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

// Makes `path` known (gi/technique.h). Once, before settings are declared; returns what stands for it.
TechniqueKind add_path();

// path.*, of reference::PathSettings.
void declare_path_settings(SettingList& list);

}  // namespace lanthorn::gi
