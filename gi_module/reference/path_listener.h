// Who is told where the light of paths comes from: for explanations, not for pictures.
#pragma once

#include <cstddef>

#include "gi_module/reference/light_source.h"
#include "gi_module/reference/trace_scene.h"

namespace lanthorn::reference {

// The last leg of a path: a ray to a light. Render space.
struct DrawnLight {
    LightSource source;
    vec3 from{0}, span{0};  // it ends at from + span
    bool to_infinity = false;
};

// Numbers of samples are of the group that begin() was told of last. Light is in nits along the path's first
// ray, as one sample of an integral over the cosine-weighed hemisphere: times pi it is lux at the path's
// start.
class PathListener {
  public:
    virtual ~PathListener() = default;
    // The samples that follow are those of the starts from `first` on.
    virtual void begin(std::size_t first) = 0;
    // The n-th surface on the path from its start, from 1.
    virtual void meets(int sample, int number, const SurfaceHit& hit) = 0;
    // Light that was reflected so many times before the path's start: 0 is straight from the light (emitters
    // as far as the path's own direction found them).
    virtual void arrives(int sample, int reflections, const DrawnLight& drawn, const vec3& light) = 0;
    // Light that would arrive if nothing stood on that leg: of the sky straight to the start all of it, of
    // other lights what they are drawn for, which is less than all where paths find them, too.
    virtual void blocked(int sample, int reflections, const DrawnLight& drawn, const vec3& light) = 0;
};

}  // namespace lanthorn::reference
