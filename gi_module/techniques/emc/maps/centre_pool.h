// A pool of centres for environment maps over a whole level, however many rooms it has; and which of them can
// be reached from a place. No box of candidates: every free place is in sight of a few. No GL.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/techniques/emc/maps/free_space.h"

namespace lanthorn::gi {

class CentrePool {
  public:
    CentrePool() = default;
    // Of what stands in `scene` within `bounds` (render space). Places are known at once, centres with
    // fill(). O(FreeSpace).
    CentrePool(const FrameScene& scene, const Aabb& bounds);

    // Free places all over the level, a block of cells each, that are reached from any of `from` (render
    // space); of them the share that some of `centres` see. O(cells + places * centres).
    double seen_share(std::span<const vec3> from, std::span<const vec3> centres) const;

    // Chooses the centres: the places in an order that `seed` decides, each unless kSight of those before it
    // are near and in its sight; then those through which ways lead that there are not yet. Cost: a look
    // at each near centre a place.
    void fill(std::uint32_t seed);
    static constexpr int kSight = 4;

    bool filled() const { return !centres_.empty(); }
    const std::vector<vec3>& centres() const { return centres_; }

    struct Reached {
        int centre = 0;
        float distance = 0;  // m, from centre to centre through free space
    };
    // The `count` nearest to `eye`, as far as a way leads there; nearest first. Of many that see each other
    // only a few. From an eye that sees none of them: from the one that is nearest. The eye sees no backs of
    // single-sided triangles, as a camera does. O(centres + count * neighbours).
    std::vector<Reached> reach(const vec3& eye, int count) const;

    // Things have moved: they are in nobody's way from now on (FreeSpace::leave_out). Whether there are more
    // ways than before. O(pairs of centres) if so.
    bool leave_out(const FrameScene& scene, std::span<const std::uint32_t> moved);

    // Everything in it has moved by the same vector. O(things + centres).
    void carry(const vec3& by);

    bool in_sight(const vec3& a, const vec3& b, float slack = 0) const {
        return space_.in_sight(a, b, slack);
    }
    bool eye_sees(const vec3& eye, const vec3& p, float slack) const {
        return space_.eye_sees(eye, p, slack);
    }
    float cell() const { return space_.side(); }  // m

  private:
    std::vector<std::uint8_t> reached_from(std::span<const vec3> from) const;
    bool near_in_sight(const vec3& a, const vec3& b) const;
    void link();
    void add(const vec3& centre, std::span<const int> in_sight);
    bool looks_both_ways(const vec3& place) const;
    std::vector<int> seen_from(const vec3& place) const;  // centres

    FreeSpace space_;
    struct Place {
        ivec3 cell{0};
        int clearance = 0;
    };
    std::vector<Place> places_;
    std::vector<vec3> centres_;
    struct Way {
        int to = 0;
        float length = 0;
    };
    std::vector<std::vector<Way>> ways_;  // by centre
};

}  // namespace lanthorn::gi
