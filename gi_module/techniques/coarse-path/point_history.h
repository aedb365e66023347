// What is known of the light at each point from the frames before: the temporal half of SVGF (Schied et al.
// 2017, sec. 4.1), for points that get different numbers of samples.
#pragma once

#include "gi_module/reference/tile_workers.h"
#include "gi_module/shared/coarse_grid/surface_point.h"
#include "lanthorn/render/camera_uniforms.h"

namespace lanthorn::gi {

// Of a point's irradiance. The shaders read it as two vec4.
struct PointEstimate {
    vec3 irradiance{0};  // lux: mean of the samples
    float second = 0;    // mean of their luminances' squares
    float samples = 0;   // that count in the means; those of frames before may count as fewer
    float frames = 0;    // that they are of
    float reserved[2] = {};

    // Takes in `count` samples with these sums. O(1).
    void add(const vec3& sum, float squares, int count);
    // The variance of the mean's luminance as its own samples tell; 0 with fewer than two.
    float variance() const;
};
static_assert(sizeof(PointEstimate) == 32);

// From where points are seen.
struct PointView {
    render::CameraUniforms camera;
    dvec3 origin{0};  // FrameScene::origin

    // Metres that points of one surface may be off each other's plane, as in coarse_surface.glsl.
    float tolerance(float distance) const;
};

// The same point where it was in the frame before, for what moves.
struct MovedInstance {
    Aabb bounds;        // render space, of this frame
    mat4 to_before{1};  // render space of this frame to render space of the frame before
};

class PointHistory {
  public:
    // Forgets everything.
    void clear() { estimates_.clear(); }

    // Makes the estimates those of `points`, seen from `view`: each point is projected into the frame before
    // and takes the estimates of the points there that lie on its surface, none if there are none. A point
    // within a mover's bounds is looked for where the mover had it first. O(points (1 + movers)).
    void follow(const GridPoints& points, const PointView& view, std::span<const MovedInstance> movers,
                reference::TileWorkers& workers);
    // Makes room for another frame's samples: all the frames' count alike up to `frames` of them, and from
    // then on exponentially less (the mean of sec. 4.1 with alpha = 1 / frames). O(points).
    void age(int frames);

    std::vector<PointEstimate>& estimates() { return estimates_; }
    const std::vector<PointEstimate>& estimates() const { return estimates_; }

  private:
    PointEstimate before(const vec3& position, const vec3& normal) const;

    GridPoints points_;  // that the estimates are of
    PointView view_;
    std::vector<PointEstimate> estimates_;
};

}  // namespace lanthorn::gi
