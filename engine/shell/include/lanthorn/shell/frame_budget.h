// A time that a frame may take, and what is drawn to keep it: smaller pictures first, then a lower preset.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::shell {

// What is spent on a picture.
struct Spending {
    std::string preset;  // low, medium, high, ultra
    double scale = 1;    // of the picture's width and height

    bool operator==(const Spending&) const = default;
};

// What to begin with where nobody has chosen. `software`: OpenGL runs on the CPU (gpu::GlInfo), which draws
// far fewer frames than a GPU.
inline constexpr double kFrameMsOnCpu = 125;  // eight frames a second
std::string usual_preset(bool software);      // "low" or "medium"
double usual_frame_ms(bool software);         // milliseconds; 0: any time
ivec2 usual_picture_size(bool software);      // pixels

// Told of every frame, it lowers what is spent once the median is above the budget, by as much as it takes,
// and raises it by one step when frames would stay well below after that for a while. A step that had to be
// taken back is tried again after twice the time, so that nothing goes up and down all the time.
class FrameBudget {
  public:
    // `ms`: that a frame may take; 0: any time. `best`: the preset that is drawn where there is time for it.
    // Starts again at the top where one of them is another than before.
    void set(double ms, const std::string& best);

    // A frame took `ms` from the one before, and kept the machine busy for `busy_ms` of that: less where it
    // waited for the screen. Cost: a sort of some thirty numbers.
    void frame(double ms, double busy_ms);
    // The next frames are no measure: a level has been loaded, the game was paused.
    void disturb();

    const Spending& spending() const { return rungs_[rung_].spending; }  // from the next frame on
    int changes() const { return changes_; }                             // so far

    static constexpr double kTolerance =
        1.03;  // of the budget: a screen's 60 pictures a second are not quite that

  private:
    struct Rung {
        Spending spending;
        double cost = 1;  // of a frame, relative to the others
    };
    struct Frame {
        double ms, busy_ms;
    };
    double busy(double share) const;
    void go_to(std::size_t rung);
    void lower();
    void raise();

    double ms_ = 0;
    std::vector<Rung> rungs_{{{"", 1}, 1}};  // dearest first
    std::size_t rung_ = 0;
    std::deque<Frame> frames_;  // since the last change, the newest last
    int disturbed_ = 0;         // frames
    double since_ = 0;          // milliseconds since the last change
    double wait_ = 0;           // milliseconds until more is tried
    bool raised_ = false;       // the last change was up
    int changes_ = 0;
};

}  // namespace lanthorn::shell
