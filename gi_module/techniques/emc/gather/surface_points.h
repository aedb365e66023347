// Surface points on the GPU, and the sizes of the dispatches over them. The GLSL side: point_lists.glsl.
#pragma once

#include <cstdint>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class SurfacePoints {
  public:
    // Room for `capacity` points with `rays` rays each a frame; there is none yet. `row`: of keys, that say
    // where a point lies: a grid's width, or a map's.
    void resize(int capacity, int row, int rays);
    // There is none, and a shader may append.
    void clear();
    // All `capacity` places are points, that a shader writes; or the first `count`.
    void fill() { fill(capacity_); }
    void fill(int count);

    int capacity() const { return capacity_; }
    int row() const { return row_; }
    int rays() const { return rays_; }
    const gpu::Buffer& points() const { return points_; }  // vec4: render space, octahedral normal
    const gpu::Buffer& keys() const { return keys_; }      // uint32: place in the grid or in the maps

    // Header, points and keys at storage bindings 0, 1 and 3, for shaders that read or append.
    void bind_storage() const;
    // One invocation a point, or one a ray.
    void dispatch() const;
    void dispatch_rays() const;

    std::uint32_t count() const;  // waits for the GPU

  private:
    gpu::Buffer header_;
    gpu::Buffer points_;
    gpu::Buffer keys_;
    int capacity_ = 0;
    int row_ = 1;
    int rays_ = 1;
};

// One invocation, in groups of 256, for each of `count` items: work_items.glsl's work_item().
void dispatch_items(int count);
// The same of a program whose items begin at its uniform `first_item`: in parts of some 3 ms of two cores,
// between which a window may answer (PassEnd), where somebody is told.
void dispatch_in_parts(const gpu::Program& program, int count);
// The same for each of `keys` in each of `rows`: x and y of gl_GlobalInvocationID.
void dispatch_rows(int keys, int rows);

}  // namespace lanthorn::gi
