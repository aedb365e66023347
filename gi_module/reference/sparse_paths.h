// The reference's indirect light at every n-th pixel of a picture: the numbers that PathTracer finds at these
// pixels, for a fraction of its time. For estimates of a technique's error while somebody waits.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "gi_module/reference/film.h"
#include "lanthorn/reference/path_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

class SparsePaths {
  public:
    // Cells of stride x stride pixels, of which the middle one is looked at; what is left over at the right
    // and lower edge has none. Keeps a copy of the scene. O(triangles log triangles); throws InputError for
    // what Embree cannot hold.
    SparsePaths(const FrameScene& scene, ivec2 size, int stride, const PathSettings& settings);
    ~SparsePaths();

    ivec2 cells() const;
    // The pixel that is looked at, rows from the top.
    ivec2 pixel(int cell) const;
    // Whether a cell sees a surface that light is gathered on.
    bool lit(int cell) const;
    // Adds so many samples to every cell, on this thread; false: `go_on` said no in between, and the last
    // ones are not in all cells. It is asked every few thousand paths.
    bool trace(int samples, const std::function<bool()>& go_on);
    int spp() const;           // samples a cell so far
    const Film& film() const;  // by cell: lux

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn::reference
