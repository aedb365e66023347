// When a picture is drawn, and how well: small while the hand moves, whole when it rests, and not at all once
// nothing changes any more.
#pragma once

#include <string_view>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::edit_window {

// What a picture is: `drag` follows the hand within a time, `rest` has the whole size, `still` is `rest` that
// has stopped changing.
enum class Quality { drag, rest, still };
std::string_view name_of(Quality quality);

// Told of what happens, it says what the next frame is drawn as. Times are seconds of one clock. The preset
// stays the same throughout: another one would make the technique's maps anew at every touch.
class Pace {
  public:
    static constexpr double kRestAfter = 0.25;  // seconds without a change by hand
    static constexpr double kDragMs = 80;       // that a frame may take while the hand moves
    static constexpr int kFewest = 7;           // frames of a rest: maps are renewed every five
    static constexpr double kStill = 5e-4;      // share of pixels that may still flicker
    static constexpr int kMost = 40;            // after which it counts as still though it flickers
    static constexpr int kMostInHand = 16;      // of a hand that holds still

    // The picture shows something that is not so any more. `by_hand`: a hand is moving it, and goes on.
    void changed(double now, bool by_hand);
    // A hand holds something (a light, the camera, a slider); frames stay small while it does.
    void hold(bool held, double now);
    bool held() const { return held_; }
    // Another scene or other settings: what frames took says nothing of the next ones.
    void forget();

    // Whether a frame is. While a hand holds still, some frames refine what it sees and no more follow.
    bool due() const { return !still_ && !(held_ && in_hand_ >= kMostInHand); }
    // Of the next frame; where none is due, of the last.
    Quality quality(double now) const;
    // Of the next frame's width and height, 0.25..1: small enough for kDragMs while the hand moves. It
    // changes once within a gesture at most, for size changes disturb the eye.
    double scale(double now) const { return quality(now) == Quality::drag ? drag_scale_ : 1; }
    // The frame that was due has been drawn at that quality and scale, in `ms`; `changed`: the share of its
    // pixels that differ from the frame before.
    void drew(Quality quality, double scale, double ms, double changed);
    int frames_at_rest() const { return rested_; }  // drawn since the hand came to rest

  private:
    void choose_scale();

    bool held_ = false;
    double changed_at_ = -1e9;  // by hand
    int rested_ = 0;
    int in_hand_ = 0;  // frames since the last change, of a hand
    bool still_ = false;
    double drag_scale_ = 1;
    // What a frame of the whole size takes: at rest, by the newest, and under a hand, where light moves, by
    // the newest few, of the gestures before as well. 0: not known.
    double whole_ms_ = 0, hand_ms_ = 0;
    double drawn_scale_ = 0;       // of the frame before
    std::vector<double> gesture_;  // milliseconds of the frames at one scale since the hand began
    int changes_ = 0;              // of the scale in this gesture
};

}  // namespace lanthorn::edit_window
