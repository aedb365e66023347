// What is remembered of a ray: the number of the lit texel that it met, or one of these.
#ifndef LANTHORN_EMC_LIT_HITS_GLSL
#define LANTHORN_EMC_LIT_HITS_GLSL

const uint kMiss = 0xffffffffu;     // a ray that met nothing
const uint kUnknown = 0xfffffffeu;  // a ray that met what no lit texel shows, or that no map could follow

#endif
