// Appends to a list of numbers at binding 7, which is the header of an indirect dispatch too (entry_list.h): of INVOCATIONS for
// each.
#ifndef LANTHORN_EMC_ENTRY_LIST_GLSL
#define LANTHORN_EMC_ENTRY_LIST_GLSL

#ifndef INVOCATIONS
#define INVOCATIONS 1u
#endif

layout(std430, binding = 7) buffer Appended { uint appended_count; uint appended_groups[3]; uint appended[]; };

// Room for `count` more, at least one: the place of the first.
uint append_entries(uint count) {
    uint at;
    TAKE_PLACES(appended_count, count, at)
    COUNT_GROUPS(appended_groups, at * INVOCATIONS, (at + count) * INVOCATIONS - 1u, 256u)
    return at;
}

void list_entry(uint entry) { appended[append_entries(1u)] = entry; }

#endif
