// `drm`: direct radiance mapping (Frisvad et al. 2005).
#pragma once

#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

// Makes `drm` known (gi/technique.h). Once, before settings are declared; returns what stands for it.
TechniqueKind add_drm();

}  // namespace lanthorn::gi
