// `coarse-path`: path tracing from a coarse grid, filtered over time and along surfaces (Schied et al. 2017).
#pragma once

#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

// Makes `coarse-path` known (gi/technique.h). Once, before settings are declared; returns what stands for it.
TechniqueKind add_coarse_path();

}  // namespace lanthorn::gi
