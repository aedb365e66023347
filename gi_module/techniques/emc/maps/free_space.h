// Where in a level there is air: a grid of cells that triangles leave empty. Conservative: a cell that a
// triangle touches is taken, so that no wall has holes; gaps narrower than two cells may be closed. No GL.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

class FreeSpace {
  public:
    FreeSpace() = default;
    // What stands in `scene` within `bounds` (render space), about a million cells. What deforms, what light
    // goes through and what is blended takes no space. O(cells + cells that triangles' boxes touch).
    FreeSpace(const FrameScene& scene, const Aabb& bounds);

    ivec3 cells() const { return cells_; }
    float side() const { return side_; }  // of a cell, m
    bool inside(const ivec3& cell) const {
        return glm::all(glm::greaterThanEqual(cell, ivec3(0))) && glm::all(glm::lessThan(cell, cells_));
    }
    ivec3 cell_of(const vec3& p) const { return ivec3(glm::floor((p - lower_) / side_)); }
    vec3 middle(const ivec3& cell) const { return lower_ + (vec3(cell) + 0.5f) * side_; }
    // Outside of the bounds all is free.
    bool free(const ivec3& cell) const { return !inside(cell) || taken_[index(cell)] == 0; }

    // Whether the way from a to b is free, but for `slack` metres about each end. O(distance / side).
    bool in_sight(const vec3& a, const vec3& b, float slack = 0) const;
    // The same for a camera at `eye`, which sees no backs of single-sided triangles: the eye may be inside a
    // closed thing, or look into a house through its wall. Conservative for triangles that face an axis of
    // the way hardly.
    bool eye_sees(const vec3& eye, const vec3& p, float slack = 0) const;

    // What moves takes no space from now on: doors are ways. Whether any of these (indices into
    // scene.instances) took some. O(their cells).
    bool leave_out(const FrameScene& scene, std::span<const std::uint32_t> moved);

    // Everything that takes space has moved by the same vector. O(things).
    void carry(const vec3& by);

    // Steps to the nearest taken cell, by cell (index()), `most` at most. O(cells).
    std::vector<std::uint8_t> clearance(int most) const;
    std::size_t index(const ivec3& c) const {
        return (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(cells_.y) +
                static_cast<std::size_t>(c.y)) *
                   static_cast<std::size_t>(cells_.x) +
               static_cast<std::size_t>(c.x);
    }

  private:
    void fill(const InstanceShape& shape, const mat4& transform, bool double_sided, int change);
    template <typename Blocks>
    bool way_is_free(const vec3& a, const vec3& b, float slack, const Blocks& blocks) const;

    vec3 lower_{0};
    float side_ = 1;
    ivec3 cells_{0};
    std::vector<std::uint16_t> taken_;  // triangles that touch the cell
    std::vector<std::uint8_t> fronts_;  // by cell, a bit an octant of directions: some may meet a front
    std::unordered_map<std::uint64_t, mat4> placed_;  // by id and mesh: what takes space, and where it stood
};

}  // namespace lanthorn::gi
