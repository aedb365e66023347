// What share of the remembered rays motion has made stale in a frame, by the lengths of lists that the GPU
// made.
#pragma once

#include <optional>

#include "engine/gpu/read_back.h"
#include "gi_module/techniques/emc/gather/entry_list.h"

namespace lanthorn::gi {

class StaleShare {
  public:
    // Of this frame, once the GPU comes to it: `stale` of `rays` rays for each of `held`.
    void note(const EntryList& held, const EntryList& stale, int rays);
    // As of now; waits for the GPU.
    static float now(const EntryList& held, const EntryList& stale, int rays);
    // Of what was noted one call of note() before the last: the same in every run, and the GPU is done with
    // it where it is two frames behind at most. Nothing if there was none.
    std::optional<float> late();
    // As if nothing had been noted.
    void forget();

  private:
    gpu::Buffer counts_;  // uint32: held, stale
    gpu::ReadBack back_;
    int under_way_ = 0;
};

}  // namespace lanthorn::gi
