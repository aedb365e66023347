// Appends to the list of entries whose rays are to be traced, at binding 7, which is the header of an indirect dispatch too.
#ifndef LANTHORN_EMC_ENTRY_LIST_GLSL
#define LANTHORN_EMC_ENTRY_LIST_GLSL

layout(std430, binding = 7) buffer Appended { uint appended_count; uint appended_groups[3]; uint appended[]; };

void list_entry(uint entry) {
    uint at = atomicAdd(appended_count, 1u);
    appended[at] = entry;
    uint group = at / 256u;
    atomicMax(appended_groups[0], min(group + 1u, kRow));
    atomicMax(appended_groups[1], group / kRow + 1u);
}

#endif
