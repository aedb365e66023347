// The progressive update of the environment maps' centres (Yao et al. 2010, sec. 4.2): when which candidates
// are seen anew, and when one map may be exchanged. No GL: it counts frames.
//
// A round begins with the first change of geometry and takes `interval` frames. Its last frames, at most ten,
// see a share of the candidates each. What the GPU measures is read a frame later, so that no frame waits for
// it: in the next frame the best candidate is known and it is asked which map it should replace, in the one
// after that they may be exchanged.
//
//   interval 5     frame     0 1 2 3 4 | 0 1 2 3 4 | 0 1
//                  share     0 1 2 3 4 | 0 1 2 3 4 |
//                  ask                 | x         | x
//                  exchange            |   x       |   x
//
// What changes after a round has begun to look is not what it judges: another round follows.
#pragma once

namespace lanthorn::gi {

class ProgressiveUpdate {
  public:
    // What a frame does.
    struct Step {
        bool round = false;  // one is under way
        int share = -1;      // of `shares`, seen in this frame; -1: none
        int shares = 1;
        int frames_left = 0;  // of the round, after this one
        bool last = false;    // of the round
        bool ask = false;     // which map the best candidate of the round before should replace
        bool exchange = false;

        int frames_to_look() const { return frames_left - shares + 1; }  // until the first share is seen
    };
    Step step(bool geometry_changes, int interval) const;
    // The frame has done it.
    void advance(bool geometry_changed, const Step& step);
    // All maps have been chosen anew.
    void reset() { *this = {}; }
    // Another interval: the frames of the round count from here.
    void restart_round() { frame_ = 0; }

    // From the end of a round to its exchange.
    static constexpr int kDelay = 2;

    // Frames that see a share each.
    static int shares(int interval);

    // The candidates of a share, from `first` to before `end`. The first share is smaller, because in its
    // frame, too, `k` maps and the best candidate of the round before are asked.
    struct Candidates {
        int first = 0;
        int end = 0;
    };
    static Candidates candidates(int share, int shares, int candidates, int k);

  private:
    int frame_ = 0;                    // of the round
    bool pending_ = false;             // geometry has changed that no finished round has seen
    bool changed_since_look_ = false;  // after the round has seen its first share
    bool looked_ = false;              // a round has ended with the last frame
    bool asked_ = false;               // the last frame has asked
};

}  // namespace lanthorn::gi
