// `emc` alone, through its maps: what needs no Embree.
#include "lanthorn/emc/emc.h"

namespace lanthorn::gi {

void register_techniques() {
    add_emc();
}

}  // namespace lanthorn::gi
