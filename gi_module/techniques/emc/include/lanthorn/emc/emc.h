// `emc`: multi-image photon tracing (Yao et al. 2010).
#pragma once

#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

// Makes `emc` known (gi/technique.h); returns what stands for it.
TechniqueKind add_emc();

}  // namespace lanthorn::gi
