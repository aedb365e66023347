// Slow, quiet music that never ends and never repeats: chords that change every eight seconds or so, and a
// few notes over them, in the tones of D minor.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/audio/samples.h"
#include "lanthorn/audio/synthesis.h"

namespace lanthorn::game {

class Music {
  public:
    // Another seed is another piece.
    explicit Music(std::uint64_t seed);

    // The next samples, left and right in turn, below 0.5; however it is cut into calls. Cost: some 2 % of a
    // core for as long as it lasts.
    void next(std::span<float> stereo);

  private:
    struct Voice {
        double step;         // radians a sample
        double left, right;  // how loud
        double rise, fall;  // a sample: what is added to `risen` up to 1, then what `fallen` is multiplied by
        double beside;      // how loud a second tone is: of a chord a little higher, of a note the octave
        double ratio;       // of the second tone to the first
        double risen = 0, fallen = 1;
        double phase = 0, second = 0;
    };
    // A delay that feeds itself: the room around it.
    struct Echo {
        std::vector<float> line;
        std::size_t at = 0;
        double feedback;
        double damped = 0;
        double next(double in);
    };

    Voice voice(double hz, double level, double attack, double decay);
    void begin_chord();
    void begin_note();
    void advance(float* frame);

    audio::Noise random_;
    std::vector<Voice> voices_;
    std::array<std::array<Echo, 3>, 2> echoes_;
    std::uint64_t samples_ = 0;  // so far, of each channel
    int chord_ = 0;
    double to_chord_ = 0, to_note_ = 2;  // seconds
};

}  // namespace lanthorn::game
