// All techniques, and exact rays for those that can use them.
#include "gi_module/shared/rays/embree_rays.h"
#include "gi_module/techniques/path/path.h"
#include "lanthorn/coarse-path/coarse_path.h"
#include "lanthorn/drm/drm.h"
#include "lanthorn/emc/emc.h"
#include "lanthorn/splat/splat.h"
#include "lanthorn/vertex-map/vertex_map.h"

namespace lanthorn::gi {

void register_techniques() {
    add_embree_rays();
    add_emc();
    add_path();
    add_coarse_path();
    add_drm();
    add_vertex_map();
    add_splat();
}

}  // namespace lanthorn::gi
