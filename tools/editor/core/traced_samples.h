// How far a picture has come whose samples grow frame by frame (`path`), and how long the rest will take.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "lanthorn/gi/statistics.h"

namespace lanthorn::editor {

class TracedSamples {
  public:
    static constexpr std::size_t kPasses = 9;  // the newest ones tell how long one takes

    void forget() { *this = {}; }
    // A frame has been drawn in so many milliseconds, and that is how far it has come. Samples that begin
    // again are of another picture: what passes took before says nothing of it.
    void drew(const gi::SampleProgress& now, double ms);

    // The picture is one whose samples grow.
    bool grows() const { return now_.wanted > 0; }
    // Another frame adds to it.
    bool due() const { return grows() && !now_.ended; }
    const gi::SampleProgress& progress() const { return now_; }
    double share() const;  // 0..1 of the samples that are wanted
    // Until all are taken, by the median of what a sample took in the newest passes; nothing: no pass has
    // been timed.
    std::optional<double> seconds_left() const;
    // The same where a sample takes so many milliseconds; 0: none is due.
    double seconds_left(double sample_ms) const;

    // "12 of 64 samples"; empty where nothing grows.
    std::string words() const;
    // "18 s left"; empty where that is not known, or nothing is left.
    std::string left_words() const;

  private:
    gi::SampleProgress now_;
    std::deque<double> ms_;  // a sample
};

}  // namespace lanthorn::editor
