// Holds a time and an error that are wished for: told of every frame, it goes up and down a ladder of ways to
// draw one. Knows nothing of what the rungs mean, nor of any clock.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace lanthorn {

// One way to draw a frame.
struct BudgetRung {
    std::string name;              // what is spared here that the rung before has: "rays 4"
    std::string preset;            // whose settings it begins with; empty: those that there are
    std::vector<std::string> set;  // KEY=VALUE, on top of them
    double scale = 1;              // of the picture's width and height
    // Milliseconds of each group of passes over those of the first rung; which pass belongs to which group
    // the ladder's maker says.
    std::vector<double> cost = {1};
    double error = 1;  // over that of the first rung

    bool operator==(const BudgetRung&) const = default;
};

// Ways to draw a frame, the dearest first.
struct BudgetLadder {
    std::vector<BudgetRung> rungs{{}};
    // Of the first rung's time, by group: what is gone by where passes are not timed. Their sum is 1.
    std::vector<double> shares = {1};

    bool operator==(const BudgetLadder&) const = default;
};

// Chooses the rung of a ladder that keeps what is wished for, by what frames took and by nothing else.
class BudgetControl {
  public:
    // What frames are to keep.
    struct Wish {
        double ms = 0;     // that a frame may take; no more than 0: any time
        double error = 0;  // that the picture may have; 0: any. Time comes first

        bool operator==(const Wish&) const = default;
    };
    // A frame that has been drawn, milliseconds.
    struct Frame {
        double ms = 0;                // since the one before
        double busy_ms = 0;           // that the machine worked of them
        std::vector<double> groups;   // the same by group of passes; empty: not known
        std::optional<double> error;  // that the picture is estimated to have
        bool refines = false;         // nothing moves, and each frame has less of it than the one before
    };
    // A change from one rung to another.
    struct Decision {
        std::int64_t frame = 0;  // the last one that was drawn as before, from 0 on
        std::size_t from = 0, to = 0;
        std::string why;  // one line
    };

    // Begins at the top, unless nothing is another than before. Throws std::invalid_argument for a ladder
    // without rungs, or whose rungs do not have as many groups as it has shares.
    void set(const Wish& wished, BudgetLadder ladder);
    // A frame has been drawn. One whose times are no times (a clock that jumped) tells nothing. Cost: a sort
    // of some thirty numbers.
    void frame(const Frame& frame);
    // The next frames are no measure: a level has been loaded, the game was paused.
    void disturb();

    const BudgetRung& rung() const { return ladder_.rungs[rung_]; }       // from the next frame on
    const BudgetLadder& ladder() const { return ladder_; }                // as it was set
    const Wish& wish() const { return wish_; }                            // likewise
    std::size_t at() const { return rung_; }                              // the rung's number, 0: the dearest
    std::int64_t changes() const { return changes_; }                     // so far
    const std::deque<Decision>& decisions() const { return decisions_; }  // the last thousand
    // What the wishes came to at last, one line: nothing was wished for, all is held, or what is not and why.
    std::string verdict() const;
    // Whether the last frames keep what was wished for; true where they are too few to tell.
    bool holds() const;

    // Of the budget: a screen's 60 pictures a second are not quite that.
    static constexpr double kTolerance = 1.03;

  private:
    double busy(double share) const;
    double predicted_ms(std::size_t rung) const;
    double predicted_error(std::size_t rung) const;
    std::optional<double> error() const;
    std::vector<double> groups_now() const;
    bool can_tell() const;
    bool decide_time();
    void decide_error();
    void raise();
    void go_to(std::size_t rung, std::string why);

    Wish wish_;
    BudgetLadder ladder_;
    std::size_t rung_ = 0;
    std::deque<Frame> frames_;  // since the last change, the newest last
    std::deque<double> errors_;
    std::optional<double> last_error_;  // of any rung
    std::int64_t count_ = 0;
    int disturbed_ = 0;    // frames
    double since_ = 0;     // milliseconds since the last change
    double wait_ = 0;      // milliseconds until more is tried
    bool raised_ = false;  // the last change was up
    double foretold_ = 1;  // milliseconds that it was to take
    double distrust_ = 1;  // by how much what was foretold of raised rungs has been too little
    std::int64_t changes_ = 0;
    std::deque<Decision> decisions_;
};

}  // namespace lanthorn
