// What is remembered of a ray: the place of the lit texel that it met (lit_place()), or one of these.
#ifndef LANTHORN_EMC_LIT_HITS_GLSL
#define LANTHORN_EMC_LIT_HITS_GLSL

const uint kListed = 0x7ffffffcu;   // a ray that is on the list of those to be traced in this frame
const uint kNoRay = 0x7ffffffdu;    // no ray is remembered there
const uint kUnknown = 0x7ffffffeu;  // a ray that met what no lit texel shows, or that no map could follow
const uint kMiss = 0x7fffffffu;     // a ray that met nothing
const uint kStale = 0x80000000u;    // beside any of them: something has moved across the ray since

uint met(uint remembered) { return remembered & ~kStale; }

#endif
