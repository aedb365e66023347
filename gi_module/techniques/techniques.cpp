#include "lanthorn/techniques/techniques.h"

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/coarse-path/coarse_path.h"
#include "lanthorn/drm/drm.h"
#include "lanthorn/splat/splat.h"
#include "lanthorn/vertex-map/vertex_map.h"

namespace lanthorn::gi {

void add_techniques() {
    add_embree_rays();
    add_coarse_path();
    add_drm();
    add_vertex_map();
    add_splat();
}

}  // namespace lanthorn::gi
