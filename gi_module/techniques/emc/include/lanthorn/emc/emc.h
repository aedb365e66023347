// `emc`: multi-image photon tracing (Yao et al. 2010), by photons on lit maps that rays gather, or splatted.
// It needs no Embree; with it, exact rays and caustics.
#pragma once

#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

// Makes `emc` known (gi/technique.h); returns what stands for it.
TechniqueKind add_emc();

}  // namespace lanthorn::gi
