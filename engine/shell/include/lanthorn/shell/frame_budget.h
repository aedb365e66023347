// A time that a frame may take, and what is drawn to keep it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn {
struct BudgetLadder;
class BudgetControl;
}  // namespace lanthorn

namespace lanthorn::shell {

// What is spent on a picture.
struct Spending {
    std::string preset;                 // low, medium, high, ultra
    double scale = 1;                   // of the picture's width and height
    std::vector<std::string> set = {};  // KEY=VALUE, on top of the preset

    bool operator==(const Spending&) const = default;
};

// What to begin with where nobody has chosen. `software`: OpenGL runs on the CPU (gpu::GlInfo), which draws
// far fewer frames than a GPU.
inline constexpr double kFrameMsOnCpu = 125;  // eight frames a second
std::string usual_preset(bool software);      // "low" or "medium"
double usual_frame_ms(bool software);         // milliseconds; 0: any time
ivec2 usual_picture_size(bool software);      // pixels

// Told of every frame, it lowers what is spent once most are above the budget, by as much as it takes,
// and raises it when frames would stay well below after that for a while. A step that had to be
// taken back is tried again after twice the time, so that nothing goes up and down all the time.
class FrameBudget {
  public:
    FrameBudget();
    ~FrameBudget();
    FrameBudget(const FrameBudget&) = delete;
    FrameBudget& operator=(const FrameBudget&) = delete;

    // `ms`: that a frame may take; 0: any time. `best`: the preset that is drawn where there is time for it.
    // Spares pixels, then presets. Starts again at the top where one of them is another than before.
    void set(double ms, const std::string& best);
    // The same with what a technique spares first (gi::quality_ladder()).
    void set(double ms, BudgetLadder ladder);

    // A frame took `ms` from the one before, and kept the machine busy for `busy_ms` of that: less where it
    // waited for the screen. Cost: a sort of some thirty numbers.
    void frame(double ms, double busy_ms);
    // The next frames are no measure: a level has been loaded, the game was paused.
    void disturb();

    const Spending& spending() const { return spending_; }  // from the next frame on
    int changes() const;                                    // so far

    static constexpr double kTolerance =
        1.03;  // of the budget: a screen's 60 pictures a second are not quite that

  private:
    void follow();

    std::unique_ptr<BudgetControl> control_;
    Spending spending_;
};

}  // namespace lanthorn::shell
