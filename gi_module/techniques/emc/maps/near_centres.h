// In a level of many rooms, whose places k maps cannot show: which centres of a pool over all of it the
// camera reaches, and what each counts in the choice of maps. No GL.
#pragma once

#include <cstdint>
#include <vector>

#include "gi_module/techniques/emc/maps/centre_pool.h"

namespace lanthorn::gi {

class NearCentres {
  public:
    // Whether k maps, about `maps`, show next to all that can be reached from the camera, and from the lamps,
    // within `bulk`; if not, a pool is filled there. Cost: CentrePool.
    void find(const FrameScene& scene, const Aabb& bulk, const std::vector<vec3>& maps, std::uint32_t seed);
    // No pool any more. What centres count stays until forget().
    void leave() { pool_ = {}; }
    void forget();
    bool found() const { return pool_.filled(); }
    const CentrePool& pool() const { return pool_; }

    // The at most `count` that are reached from `eye`, for take().
    void reach(const vec3& eye, int count);
    // Once a frame: looks again where the camera has come some way, or where there are other ways. `carried`:
    // all has moved by the same vector, so that no way is another. Whether it has looked again.
    bool follow(const FrameScene& scene, bool carried, int count);
    // Whether the camera sees one of the maps no more, which it did when it was asked last. `maps` as find()
    // takes them.
    bool lost(const std::vector<vec3>& maps);
    void carry(const vec3& by);

    // Makes room for more candidates than there are, where more are reached.
    void make_room(std::vector<vec3>& candidates);
    // Candidates are those that the camera reaches: those that stay keep their places, and so do those in use
    // (`kept`, by candidate).
    void take(const FrameScene& scene, std::vector<vec3>& candidates, std::vector<bool> kept);

    // By candidate: what its area counts, 1 without rooms; whether the camera reaches it.
    double weight(std::size_t candidate) const { return candidate < weight_.size() ? weight_[candidate] : 1; }
    bool left_behind(std::size_t candidate) const;

  private:
    std::vector<double> weights_of_reached(const FrameScene& scene) const;
    bool sees_one_of(const std::vector<vec3>& maps) const;

    CentrePool pool_;
    std::vector<CentrePool::Reached> reached_;  // of it, from the camera
    std::vector<int> pooled_;                   // by candidate: which of the pool
    std::vector<double> weight_;                // by candidate; empty: 1
    vec3 eye_{0};                               // that reached_ is from
    vec3 camera_{0};                            // where it is now
    bool in_sight_ = false;                     // the camera saw a map when it was looked for last
};

}  // namespace lanthorn::gi
