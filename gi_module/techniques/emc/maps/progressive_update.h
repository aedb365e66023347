// The progressive update of the environment maps' centres (Yao et al. 2010, sec. 4.2): when which candidates
// are looked at again, and when one map may be exchanged. No GL: it counts frames.
//
// Rounds begin with the first change of geometry and take `interval` frames each. Its last frames, at most
// ten, see a share of the candidates each. What the GPU measures is read a frame later, so that no frame
// waits for it: in the next frame the best candidate is known and it is asked which map it should replace, in
// the one after that they may be exchanged.
//
//   interval 5     frame     0 1 2 3 4 | 0 1 2 3 4 | 0 1
//                  share     0 1 2 3 4 | 0 1 2 3 4 |
//                  ask                 | x         | x
//                  exchange            |   x       |   x
//
// Rounds end with the first one that finds nothing to exchange and saw all of its candidates after the last
// change of geometry or of a map; the round that has begun by then is given up. Measured coverage is noisy,
// so exchanges might never end: at most kMostExchanges follow the last change of geometry.
#pragma once

#include <cstdint>
#include <optional>

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
    // The frame has done it. `exchanged`: another map is in C since.
    void advance(bool geometry_changed, bool exchanged, const Step& step);
    // All maps have been chosen again.
    void reset() { *this = {}; }
    // Another interval: the frames of the round count from here.
    void restart_round() { frame_ = 0; }

    // From the end of a round to its exchange.
    static constexpr int kDelay = 2;
    static constexpr int kMostExchanges = 48;

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
    bool settled() const { return settled_ == changes_; }

    int frame_ = 0;                        // of the round
    std::uint64_t changes_ = 0;            // of geometry, frame by frame, and of C
    std::uint64_t settled_ = 0;            // as many of them as a round that found nothing has seen
    std::uint64_t looking_ = 0;            // as many as the round that looks sees, or the one before
    std::optional<std::uint64_t> looked_;  // as many as the round saw that has ended with the last frame
    std::optional<std::uint64_t> asked_;   // as many as the round saw that the last frame has asked about
    int exchanges_ = 0;                    // since geometry has changed
};

}  // namespace lanthorn::gi
