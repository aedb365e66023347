// Hints on demand: each time the player asks, a plainer one.
#pragma once

#include <string>
#include <vector>

namespace lanthorn::game {

class Hints {
  public:
    // `hints`: the level's, from the faintest to the plainest. Asked again, the next one shows; after the
    // last the last again. A level without hints says so.
    void ask(const std::vector<std::string>& hints);
    void pass(double seconds);
    void forget() { *this = {}; }

    const std::string& shown() const { return shown_; }  // empty: nothing

    static constexpr double kShownSeconds = 12;

  private:
    std::size_t next_ = 0;
    std::string shown_;
    double left_ = 0;
};

}  // namespace lanthorn::game
