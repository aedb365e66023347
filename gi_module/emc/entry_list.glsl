// Appends to the list of entries whose rays are to be traced, at binding 7, which is the header of an indirect dispatch too.
#ifndef LANTHORN_EMC_ENTRY_LIST_GLSL
#define LANTHORN_EMC_ENTRY_LIST_GLSL

layout(std430, binding = 7) buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

void list_entry(uint entry) {
    uint at = atomicAdd(listed_count, 1u);
    list[at] = entry;
    uint group = at / 256u;
    atomicMax(listed_groups[0], min(group + 1u, kRow));
    atomicMax(listed_groups[1], group / kRow + 1u);
}

#endif
