// `splat`: exact photons splatted onto the picture (Lavignotte and Paulin 2003).
#pragma once

#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

// Makes `splat` known (gi/technique.h). Once, before settings are declared; returns what stands for it.
TechniqueKind add_splat();

}  // namespace lanthorn::gi
