// Time to look: the player sees what she has done before words, or another level, come over it.
#pragma once

namespace lanthorn::game {

class Lingering {
  public:
    static constexpr double kSeconds = 3;

    // Of a frame `seconds` long: whether what is looked at has been `done` for longer than that.
    bool pass(bool done, double seconds) {
        passed_ = done ? passed_ + seconds : 0;
        return passed_ > kSeconds;
    }
    void forget() { passed_ = 0; }

  private:
    double passed_ = 0;
};

}  // namespace lanthorn::game
