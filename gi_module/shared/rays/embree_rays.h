// gi.emc.rays = bvh: rays on Embree, on all cores.
#pragma once

namespace lanthorn::gi {

// Makes make_exact_rays() know them.
void add_embree_rays();

}  // namespace lanthorn::gi
