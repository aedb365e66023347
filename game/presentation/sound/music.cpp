#include "game/presentation/sound/music.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanthorn::game {

using audio::kSampleRate;
using audio::samples_in;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// Half tones above D2, 73.4 Hz.
double pitch(int half_tones) {
    return 73.416 * std::exp2(half_tones / 12.0);
}

// Chords as half tones above D2; from each to one of the others that share a tone with it.
constexpr std::array<std::array<int, 4>, 5> kChords = {{
    {0, 7, 15, 19},   // D minor
    {-4, 8, 12, 15},  // B flat
    {3, 10, 15, 19},  // F
    {5, 12, 15, 20},  // G minor
    {-2, 10, 14, 17}  // C
}};
constexpr std::array<std::array<int, 3>, 5> kNext = {{{1, 2, 3}, {2, 3, 0}, {0, 4, 1}, {0, 1, 4}, {0, 2, 3}}};
constexpr std::array<int, 8> kScale = {24, 27, 29, 31, 34, 36, 39, 41};  // pentatonic, for single notes

constexpr double kPadLevel = 0.045, kNoteLevel = 0.06;

}  // namespace

Music::Music(std::uint64_t seed) : random_(seed) {
    // Primes, in samples: no two echoes fall together.
    constexpr std::array<std::array<std::size_t, 3>, 2> kLengths = {{{4271, 5563, 7013}, {4451, 5783, 6761}}};
    for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t i = 0; i < 3; ++i) {
            echoes_[side][i].line.assign(kLengths[side][i], 0.0f);
            echoes_[side][i].feedback = 0.74 - 0.03 * static_cast<double>(i);
        }
    }
}

double Music::Echo::next(double in) {
    const double out = static_cast<double>(line[at]);
    damped += 0.35 * (out - damped);  // walls take the high tones first
    line[at] = static_cast<float>(in + feedback * damped);
    at = (at + 1) % line.size();
    return out;
}

// Falls to a thousandth in `decay` seconds.
Music::Voice Music::voice(double hz, double level, double attack, double decay) {
    const double pan = random_.between(0.15, 0.85);
    return {.step = kTurn * hz / kSampleRate,
            .left = level * std::sqrt(1 - pan),
            .right = level * std::sqrt(pan),
            .rise = 1 / (attack * kSampleRate),
            .fall = std::pow(1e-3, 1 / (decay * kSampleRate)),
            .beside = 0,
            .ratio = 1};
}

void Music::begin_chord() {
    chord_ = kNext[static_cast<std::size_t>(chord_)][random_.word() % 3];
    for (const int tone : kChords[static_cast<std::size_t>(chord_)]) {
        Voice pad = voice(pitch(tone), kPadLevel, 3.5, 14);
        pad.beside = 0.7;
        pad.ratio = 1.003;
        voices_.push_back(pad);
    }
    to_chord_ += random_.between(7, 10);
}

void Music::begin_note() {
    const int tone = kScale[random_.word() % kScale.size()];
    const double level = kNoteLevel * random_.between(0.4, 1);
    Voice note = voice(pitch(tone), level, 0.006, random_.between(2, 3.5));
    note.beside = 0.15;
    note.ratio = 2;
    voices_.push_back(note);
    to_note_ += random_.between(0, 1) > 0.3 ? random_.between(0.6, 1.4) : random_.between(3, 7);
}

void Music::advance(float* frame) {
    constexpr double kStep = 1.0 / kSampleRate;
    if (to_chord_ <= 0) {
        begin_chord();
    }
    if (to_note_ <= 0) {
        begin_note();
    }
    to_chord_ -= kStep;
    to_note_ -= kStep;
    double left = 0, right = 0;
    for (Voice& v : voices_) {
        const double value = v.risen * v.fallen * (std::sin(v.phase) + v.beside * std::sin(v.second));
        left += v.left * value;
        right += v.right * value;
        v.phase = std::fmod(v.phase + v.step, kTurn);
        v.second = std::fmod(v.second + v.ratio * v.step, kTurn);
        if (v.risen < 1) {
            v.risen = std::min(v.risen + v.rise, 1.0);
        } else {
            v.fallen *= v.fall;
        }
    }
    const double dry[] = {left, right};
    for (std::size_t side = 0; side < 2; ++side) {
        double room = 0;
        for (Echo& echo : echoes_[side]) {
            room += echo.next(0.35 * dry[side]);
        }
        frame[side] = static_cast<float>(0.5 * std::tanh(dry[side] + 0.5 * room));
    }
    if (++samples_ % 1024 == 0) {
        std::erase_if(voices_, [](const Voice& v) { return v.fallen < 1e-4; });
    }
}

void Music::next(std::span<float> stereo) {
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
        advance(&stereo[i]);
    }
}

}  // namespace lanthorn::game
