// Which frames of photons the mean of the lit maps holds: many while nothing changes, few while something
// does, and none of before where that is worth nothing any more. Counts are in units of gi.gather.photons.
#pragma once

#include <optional>

namespace lanthorn::gi {

class PhotonMean {
  public:
    static constexpr int kFrames = 16;  // units in the mean of a still scene; after them none is added
    static constexpr int kFirst = 4;    // units of a first frame, which has no mean

    // What there is to be told of a frame.
    struct Change {
        bool any = false;       // light or surfaces are not those of the frame before
        bool surfaces = false;  // surfaces are not
        float drift = 0;        // how far the lamp that did most has moved, of EnvironmentMaps::extent(), or
                                // turned, in radians
    };
    // Photons to be traced in a frame.
    struct Frame {
        int times = 1;  // units
        int pass = 0;   // the number of this many in the sequences of random numbers
        int held = 0;   // units in the mean that they are added to, at most
    };

    // Nothing is remembered.
    void forget() {
        units_ = 0;
        was_first_ = false;
    }
    // Lamps are others than before: the frame that comes begins a mean.
    void begin() { units_ = 0; }
    // The maps show other surfaces, of which the mean knows nothing: it takes frames for them.
    void make_room();
    // The frame that comes next, which is in units() then; nothing if the mean holds all.
    std::optional<Frame> next(const Change& change);

    int units() const { return units_; }  // in the mean, at most

  private:
    int still_ = 0;  // frames since light or surfaces changed
    int units_ = 0;
    int next_ = 0;            // units that were traced of the sequences of random numbers
    bool was_first_ = false;  // the frame before began a mean
    bool mixed_ = false;      // the mean holds frames from before a change, too
};

}  // namespace lanthorn::gi
