// What sounds are made of: noise, resonance, decaying tones. The same numbers in every run.
#pragma once

#include <cstdint>
#include <span>

#include "lanthorn/audio/samples.h"

namespace lanthorn::audio {

// White noise, uniform in -1..1: PCG-XSH-RR 64/32 (O'Neill 2014).
class Noise {
  public:
    explicit Noise(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 1442695040888963407u) { word(); }
    std::uint32_t word();                                                     // the next 32 bits
    double next() { return static_cast<double>(word()) / 2147483647.5 - 1; }  // the next number, -1..1
    // Uniform in low..high.
    double between(double low, double high) { return low + (high - low) * 0.5 * (next() + 1); }

  private:
    std::uint64_t state_;
};

// A biquad of two poles and two zeros (Bristow-Johnson, Cookbook formulae for audio EQ biquad filters).
class Filter {
  public:
    // What passes: frequencies below the cut-off, around the centre, or above the cut-off.
    enum class Kind { low, band, high };
    // `hz`: cut-off or centre, below half the sample rate; `q`: how narrow. The band's peak is 1.
    Filter(Kind kind, double hz, double q);
    // The next sample that comes out when `in` goes in; samples are given in order, kSampleRate a second.
    double next(double in);

  private:
    double b0_, b1_, b2_, a1_, a2_;
    double x1_ = 0, x2_ = 0, y1_ = 0, y2_ = 0;
};

// A tone that rises within `attack` seconds and then falls to a thousandth in `decay` more; its octave and
// other partials are tones of their own.
struct Tone {
    double at = 0;  // seconds
    double hz = 440;
    double level = 1;
    double attack = 0.005;
    double decay = 0.5;
    double glide = 1;  // its pitch at the end, of that at the beginning
};

// Noise through a band-pass, risen and fallen likewise.
struct Burst {
    double at = 0;  // seconds
    double hz = 800;
    double q = 1;
    double level = 1;
    double attack = 0.003;
    double decay = 0.1;
    std::uint64_t seed = 1;
};

// Adds to what is there; what would come after the end is left out.
void add(Samples& out, const Tone& tone);
// The same for a burst, which is about as loud whatever its `q`.
void add(Samples& out, const Burst& burst);

// What is played once: without a constant part, its ends faded to 0, its peak `peak` (below 1).
void finish(Samples& samples, double peak);

// What is played round and round: the last `seconds` are faded into the beginning and cut off, so that the
// end goes on into it; no constant part, its peak `peak`.
void finish_loop(Samples& samples, double seconds, double peak);

}  // namespace lanthorn::audio
