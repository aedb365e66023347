#include "lanthorn/techniques/techniques.h"

#include "lanthorn/coarse/coarse_path_technique.h"
#include "lanthorn/drm/drm_technique.h"
#include "lanthorn/photon_splat/photon_splat_technique.h"
#include "lanthorn/rays/embree_rays.h"
#include "lanthorn/vertex_map/vertex_map_technique.h"

namespace lanthorn::gi {

void add_techniques() {
    add_embree_rays();
    add_coarse_path();
    add_drm();
    add_vertex_map();
    add_photon_splat();
}

}  // namespace lanthorn::gi
