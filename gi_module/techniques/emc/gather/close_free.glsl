// The slots that close hits may take, and how many want one (close_hits.h).
#ifndef LANTHORN_EMC_CLOSE_FREE_GLSL
#define LANTHORN_EMC_CLOSE_FREE_GLSL

const uint kCloseLots = 256u;

layout(std430, binding = 12) buffer CloseFree {
    uint close_taken;  // in this frame
    uint close_free_count;
    uint close_before;     // taken before the rays that are looked up now
    uint close_lots;       // of kCloseLots, that may take slots
    uint close_groups[4];  // to look those rays up again
    uint close_wanted[kCloseLots];
    uint close_free[];  // slots
};

#endif
