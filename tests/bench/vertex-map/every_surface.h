// Shooting as Jozwowski 2002 did it: a photon asks every surface of the scene (sec. 4.4, "Finding Hit
// Points": time "is directly proportional to the number of surfaces").
#pragma once

#include <cstdint>
#include <vector>

#include "gi_module/techniques/vertex-map/photon_store.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::bench {

class EverySurface {
  public:
    // Of instances that stand where their meshes do, made of parallelograms, four vertices each in order
    // (thesis_scene()).
    explicit EverySurface(const FrameScene& scene);

    // Metres to the nearest surface that the ray meets; infinite: none. O(surfaces).
    float nearest(const vec3& origin, const vec3& direction) const;

    // The rays of the photons whose places have changed since forget_changed(), from a lamp at `lamp`.
    struct Asked {
        std::uint64_t rays = 0;
        std::uint64_t agree = 0;  // met what the store says
    };
    Asked ask(const gi::PhotonStore& store, const vec3& lamp) const;

    std::size_t size() const { return surfaces_.size(); }

  private:
    struct Parallelogram {
        vec3 corner, normal;
        vec3 along_u, along_v;  // u of a point p is dot(p - corner, along_u), 0..1 within
    };
    std::vector<Parallelogram> surfaces_;
};

}  // namespace lanthorn::bench
