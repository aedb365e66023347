// What is remembered of a ray in 32 bits: the place of the lit texel (lit_place()) or the part of the sky that it met, or one of
// the words below; how much it counts; and whether it is stale.
#ifndef LANTHORN_EMC_LIT_HITS_GLSL
#define LANTHORN_EMC_LIT_HITS_GLSL

const uint kListed = 0x00fffffbu;   // a ray that is on the list of those to be traced in this frame
const uint kNoRay = 0x00fffffcu;    // no ray is remembered there
const uint kUnlit = 0x00fffffdu;    // a ray that met what no lit texel shows
const uint kUnknown = 0x00fffffeu;  // a ray that no map could follow, or that has not been traced yet
const uint kMet = 0x00ffffffu;      // the bits of what was met
const uint kStale = 0x80000000u;    // beside any of them: something has moved across the ray since

// 7 bits beside them: how much a ray counts, of what one of a cosine lobe does. 0: as much; it was not guided.
const uint kWeightShift = 24u;
const uint kWeightBits = 0x7f000000u;
const float kWeightUnits = 1024.0;
float weight_of(uint code) { return code == 0u ? 1.0 : float(code * code) * (1.0 / kWeightUnits); }
float ray_weight(uint remembered) { return weight_of((remembered & kWeightBits) >> kWeightShift); }

// Of a close hit that no lit texel shows, instead of that texel's place: its albedo, red in the lowest byte.
uint close_albedo(uint albedo) { return 0x80000000u | (albedo & 0x00ffffffu); }
bool is_close_albedo(uint owner) { return owner >= 0x80000000u; }
// The same beside what it reflects of direct light, in `a` of its radiosity; 0 of close hits that reflect all light that they have.
float reflects_more(uint owner) { return float(owner & 0x00ffffffu) + 1.0; }
vec3 more_albedo(float a) { return a > 0.0 ? unpackUnorm4x8(uint(a - 1.0)).rgb : vec3(0.0); }

uint met(uint remembered) { return remembered & kMet; }
// The same ray, which has met something else, and is not stale.
uint meets(uint remembered, uint id) { return (remembered & ~(kMet | kStale)) | id; }

#endif
