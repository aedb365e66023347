// Indirect dispatches of more work groups than GL promises along an axis: rows of them.
#ifndef LANTHORN_WORK_ITEMS_GLSL
#define LANTHORN_WORK_ITEMS_GLSL

const uint kRow = 16384u;  // work groups a row of a dispatch: GL promises no more than 65535

// Dispatches `groups` (x, y) of `size` invocations each for a list that now holds items `first` to `last`, too: told by who begins a
// group, since an atomic that all invocations wait for costs more than what they do.
#define COUNT_GROUPS(groups, first, last, size) \
    if ((first) % (size) == 0u || (first) / (size) != (last) / (size)) { \
        atomicMax(groups[0], min((last) / (size) + 1u, kRow)); \
        atomicMax(groups[1], (last) / (size) / kRow + 1u); \
    }

// `at`: the first of `count` places more in the list that `counter` counts. All invocations of a list wait for that counter: where
// there are subgroups, one asks for all of its own that come here together.
#ifdef SUBGROUPS
#define TAKE_PLACES(counter, count, at) { \
        uint before_ = subgroupExclusiveAdd(count); \
        uint all_ = subgroupAdd(count); \
        uint first_ = subgroupElect() ? atomicAdd(counter, all_) : 0u; \
        at = subgroupBroadcastFirst(first_) + before_; \
    }
#else
#define TAKE_PLACES(counter, count, at) at = atomicAdd(counter, count);
#endif

uint work_item() { return (gl_WorkGroupID.y * kRow + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

#endif
