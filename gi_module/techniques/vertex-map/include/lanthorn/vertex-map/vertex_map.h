// `vertex-map`: photons in a k-d tree, light at vertices (Jozwowski 2002).
#pragma once

#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

// Makes `vertex-map` known (gi/technique.h). Once, before settings are declared; returns what stands for it.
TechniqueKind add_vertex_map();

}  // namespace lanthorn::gi
