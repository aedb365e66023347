#include "game/presentation/sound/effects.h"

#include <cmath>
#include <initializer_list>

#include "lanthorn/audio/synthesis.h"

namespace lanthorn::game {

using namespace audio;

namespace {

Samples silence(double seconds) {
    return Samples(samples_in(seconds), 0.0f);
}

struct Partial {
    double ratio, level, decay;  // of the deepest one; seconds
};

void strike(Samples& out, double at, double hz, double level, std::initializer_list<Partial> partials) {
    for (const Partial& p : partials) {
        add(out, Tone{at, p.ratio * hz, level * p.level, 0.002, p.decay, 1});
    }
}

// A small bell: the higher partials, which are out of tune, die first.
void bell(Samples& out, double at, double hz, double level, double decay) {
    strike(out, at, hz, level,
           {{1, 1, decay}, {2.003, 0.5, 0.7 * decay}, {2.98, 0.22, 0.4 * decay}, {5.4, 0.1, 0.15 * decay}});
}

// A heel on stone, and the sole after it.
Samples step(double hz, std::uint64_t seed) {
    Samples out = silence(0.24);
    add(out, Tone{0, hz, 0.7, 0.002, 0.09, 0.6});
    add(out, Burst{0, 320, 0.8, 0.5, 0.002, 0.08, seed});
    add(out, Burst{0.045, 1500, 0.7, 0.12, 0.01, 0.12, seed + 1});
    finish(out, 0.5);
    return out;
}

Samples handle(double hz, bool down) {
    Samples out = silence(0.4);
    strike(out, 0, hz, 0.4, {{1, 1, 0.12}, {1.47, 0.7, 0.09}, {2.16, 0.5, 0.06}});
    if (down) {
        add(out, Tone{0, 130, 0.9, 0.001, 0.1, 0.7});
        add(out, Burst{0, 500, 1, 0.4, 0.001, 0.06, 21});
    } else {
        strike(out, 0.07, 1.12 * hz, 0.25, {{1, 1, 0.1}, {1.47, 0.6, 0.07}});
    }
    finish(out, 0.45);
    return out;
}

Samples lantern_on() {
    Samples out = silence(0.7);
    add(out, Burst{0, 4200, 0.8, 0.5, 0.01, 0.1, 31});  // the spark
    add(out, Burst{0.06, 700, 0.7, 0.6, 0.08, 0.45, 32});
    add(out, Tone{0.06, 95, 0.6, 0.06, 0.35, 1.4});
    finish(out, 0.5);
    return out;
}

Samples lantern_off() {
    Samples out = silence(0.5);
    add(out, Burst{0, 1100, 0.6, 0.7, 0.02, 0.18, 35});
    add(out, Burst{0.03, 420, 0.8, 0.4, 0.03, 0.4, 36});
    finish(out, 0.4);
    return out;
}

// The wick's wheel clicks, and the flame answers.
Samples wick(bool up) {
    Samples out = silence(0.35);
    for (int i = 0; i < 3; ++i) {
        add(out, Burst{0.04 * i, 2600, 4, 0.5, 0.001, 0.02, 41u + static_cast<unsigned>(i)});
    }
    add(out, Tone{0.05, up ? 330.0 : 440.0, 0.12, 0.04, 0.25, up ? 1.33 : 0.75});
    finish(out, 0.35);
    return out;
}

Samples glass() {
    Samples out = silence(0.9);
    strike(out, 0, 1870, 0.5, {{1, 1, 0.8}, {2.32, 0.6, 0.5}, {3.8, 0.35, 0.25}});
    add(out, Burst{0, 5200, 2, 0.2, 0.001, 0.03, 51});
    finish(out, 0.35);
    return out;
}

Samples thud(double hz, double decay, std::uint64_t seed) {
    Samples out = silence(0.5);
    add(out, Tone{0, hz, 1, 0.001, decay, 0.8});
    add(out, Tone{0, 2.7 * hz, 0.3, 0.001, 0.5 * decay, 0.9});
    add(out, Burst{0, 480, 0.8, 0.5, 0.001, 0.09, seed});
    finish(out, 0.6);
    return out;
}

// D minor pentatonic upwards.
Samples chime(std::initializer_list<double> notes, double apart, double decay) {
    Samples out = silence(apart * static_cast<double>(notes.size()) + decay);
    double at = 0;
    for (const double hz : notes) {
        bell(out, at, hz, 0.5, decay);
        at += apart;
    }
    finish(out, 0.6);
    return out;
}

Samples click(double hz) {
    Samples out = silence(0.12);
    add(out, Tone{0, hz, 0.6, 0.001, 0.06, 0.9});
    add(out, Burst{0, 1800, 1.5, 0.25, 0.001, 0.02, 61});
    finish(out, 0.3);
    return out;
}

// A hinge that sticks and slips: knocks close together, in no even time, through the wood's resonances.
Samples creak() {
    constexpr double kSeconds = 2.6, kOverlap = 0.4;
    Samples out = silence(kSeconds);
    Noise noise(71);
    audio::Filter wood[] = {{audio::Filter::Kind::band, 310, 9},
                            {audio::Filter::Kind::band, 690, 12},
                            {audio::Filter::Kind::band, 1240, 14}};
    double next = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double t = static_cast<double>(i) / kSampleRate;
        double in = 0.004 * noise.next();
        if (t >= next) {
            in += 0.6 + 0.4 * noise.next();
            next += noise.between(0.011, 0.03);
        }
        out[i] = static_cast<float>(1.0 * wood[0].next(in) + 0.8 * wood[1].next(in) + 0.4 * wood[2].next(in));
    }
    finish_loop(out, kOverlap, 0.4);
    return out;
}

// Something heavy that slides: noise in two bands, louder and softer as it catches.
Samples scrape(double low, double high, double catches, std::uint64_t seed, double peak) {
    constexpr double kSeconds = 2.4, kOverlap = 0.4;
    Samples out = silence(kSeconds);
    Noise noise(seed), unevenness(seed + 1);
    audio::Filter deep(audio::Filter::Kind::band, low, 1.2), bright(audio::Filter::Kind::band, high, 1.6);
    audio::Filter slow(audio::Filter::Kind::low, catches, 0.7);
    for (float& s : out) {
        const double in = noise.next();
        const double grip = 1 + 5 * slow.next(unevenness.next());
        s = static_cast<float>(grip * (deep.next(in) + 0.45 * bright.next(in)));
    }
    finish_loop(out, kOverlap, peak);
    return out;
}

// A hum of fifths that beats slowly; whole periods, so that the end is the beginning.
Samples hum() {
    constexpr double kSeconds = 2;
    Samples out = silence(kSeconds);
    constexpr double kPi2 = 6.283185307179586;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double t = static_cast<double>(i) / kSampleRate;
        double sum = 0;
        for (const auto& [hz, level] :
             {std::pair(220.0, 1.0), {220.5, 0.8}, {330.0, 0.5}, {330.5, 0.4}, {880.5, 0.12}}) {
            sum += level * std::sin(kPi2 * hz * t);
        }
        out[i] = static_cast<float>(sum);
    }
    finish_loop(out, 0, 0.35);
    return out;
}

}  // namespace

Samples synthesise(SoundKind::Name kind) {
    switch (kind) {
        case SoundKind::step_left:
            return step(92, 11);
        case SoundKind::step_right:
            return step(84, 13);
        case SoundKind::take:
            return handle(2100, false);
        case SoundKind::put_down:
            return handle(1750, true);
        case SoundKind::lantern_on:
            return lantern_on();
        case SoundKind::lantern_off:
            return lantern_off();
        case SoundKind::brighter:
            return wick(true);
        case SoundKind::darker:
            return wick(false);
        case SoundKind::glass:
            return glass();
        case SoundKind::door_shut:
            return thud(78, 0.3, 55);
        case SoundKind::shutter_stops:
            return thud(140, 0.16, 57);
        case SoundKind::crystal_wakes:
            return chime({587.33, 880, 1174.66}, 0.11, 1.9);
        case SoundKind::solved:
            return chime({293.66, 440, 587.33, 698.46, 880, 1174.66}, 0.2, 2.6);
        case SoundKind::choose:
            return click(520);
        case SoundKind::change:
            return click(700);
        case SoundKind::door_moves:
            return creak();
        case SoundKind::shutter_slides:
            return scrape(420, 1500, 18, 81, 0.4);
        case SoundKind::pushed:
            return scrape(170, 640, 9, 83, 0.5);
        case SoundKind::turned:
            return scrape(240, 900, 30, 85, 0.4);
        case SoundKind::crystal_charges:
            return hum();
    }
    return {};
}

std::vector<Effect> effects() {
    std::vector<Effect> all;
    for (int i = 0; i < kSoundKinds; ++i) {
        const auto kind = static_cast<SoundKind::Name>(i);
        all.push_back({synthesise(kind), goes_on(kind)});
    }
    return all;
}

}  // namespace lanthorn::game
