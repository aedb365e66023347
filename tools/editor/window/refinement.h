// A still picture that is made better while nobody needs the machine (gi.accumulate): how far, and what the
// badge says of it.
#pragma once

#include <optional>
#include <string>

#include "lanthorn/core/settings.h"

namespace lanthorn::edit_window {

// Told of a picture that has become still, it says whether one frame more is to be drawn, each with other
// rays, until the error that the technique estimates (relRMSE) is small enough or the time is spent.
class Refinement {
  public:
    static constexpr double kUsualTarget = 0.04;  // where gi.target_error asks for none
    static constexpr double kMostSeconds = 20;    // of drawing, for one picture

    // Whether gi.technique can say when a picture is good enough; others are left as they are.
    static bool possible(const Settings& settings);
    // What the technique needs for it: gi.accumulate, if it is the default's, as many passes as there may be.
    // It estimates nothing by itself: that is asked for between frames.
    static void prepare(Settings& settings);

    // The picture has changed, or is about to.
    void forget() { *this = {}; }
    // It is still, with that estimated error; nothing: the technique does not say, and nothing follows.
    // `settings` say how far: gi.target_error, gi.accumulate.
    void begin(std::optional<double> error, const Settings& settings);
    // Whether another frame is to be drawn.
    bool due() const { return known_ && !reached_ && frames_ < most_frames_ && ms_ < 1e3 * kMostSeconds; }
    // At least one frame has been drawn.
    bool begun() const { return frames_ > 0; }
    // One was, in so many milliseconds. Whether the error is to be asked for: after each eighth more of them.
    bool drew(double ms);
    void estimated(std::optional<double> error);

    // "refining: error about 0.061"; "refined: error about 0.039"; "refined for 20 s: error about 0.052".
    // "error about 0.031" where that is little enough as it is; empty: there is nothing to say.
    std::string words() const;

  private:
    bool known_ = false, reached_ = false;
    double error_ = 0, target_ = 0, ms_ = 0;
    int frames_ = 0, ask_at_ = 0, most_frames_ = 0;
};

}  // namespace lanthorn::edit_window
