// Rays that ask the environment maps in rounds: whom one map cannot settle asks the next, and the few left
// then ask all. On a software rasteriser, which runs every lane as long as the slowest, that took a third of
// the time of asking all maps at once (docs/measurements.md).
#pragma once

#include <functional>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class MapRounds {
  public:
    // Memory for so many rays.
    void resize(std::size_t rays);
    // The last round with an invocation for each ray and map, which keep the nearest hit: of a word by ray at
    // storage binding 7, behind four. A GPU does many short ones sooner than few that are long.
    struct EachMap {
        const gpu::Program &nobody, &each,
            &nearest;  // dispatched one after the other; `each` for all maps (z)
        int maps;
    };
    // Runs `one_map` in each round but the last, in that one `every_map`, or `apart` if there is one; where
    // the settings want all maps asked `every_map` is the only one. `prepare` uses the given program and sets
    // its uniforms (but `listed`); `start` dispatches it over all rays, for the first round. The lists of
    // rays that are not settled are at storage bindings 6 (read) and 7 (written).
    void run(const gpu::Program& one_map, const gpu::Program& every_map, const GiSettings& settings,
             const std::function<void(const gpu::Program&)>& prepare,
             const std::function<void(const gpu::Program&)>& start, const EachMap* apart = nullptr);

  private:
    void run_apart(const EachMap& apart, const gpu::Buffer& listed, const gpu::Buffer& nearest,
                   const std::function<void(const gpu::Program&)>& prepare);

    // Behind their count and three group counts: one list is read, one written.
    gpu::Buffer unsettled_[2];
};

}  // namespace lanthorn::gi
