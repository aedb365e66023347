// Lists that up-sampling writes of the pixels to be gathered, and the sizes of the indirect dispatches that work them off.
// Places in lists come from atomics: they decide which invocation does a pixel, never what it finds.
#ifndef LANTHORN_EMC_SPLAT_LISTS_GLSL
#define LANTHORN_EMC_SPLAT_LISTS_GLSL

#include "engine/gpu/work_items.glsl"

layout(std430, binding = 6) buffer SplatDispatches {
    uint batch_groups[3];  // one work group a batch of kBatch pixels
    uint new_groups[3];    // one work group 64 pixels whose boundaries are not known yet
    uint batch_count;
    uint new_count;
};

#ifndef BATCH
#define BATCH 8u
#endif
const uint kBatch = BATCH;  // pixels of one tile that are gathered together

uint row_index(uvec3 group) { return group.y * kRow + group.x; }

#endif
