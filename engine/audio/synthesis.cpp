#include "lanthorn/audio/synthesis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanthorn::audio {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// Of a tone or burst, `t` seconds after its beginning.
double envelope(double t, double attack, double decay) {
    const double rise = attack > 0 ? std::min(t / attack, 1.0) : 1;
    return rise * std::pow(1e-3, std::max(t - attack, 0.0) / decay);
}

void take_out_constant(Samples& samples) {
    double sum = 0;
    for (const float s : samples) {
        sum += static_cast<double>(s);
    }
    const auto mean = static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(samples.size(), 1)));
    for (float& s : samples) {
        s -= mean;
    }
}

void scale_to(Samples& samples, double peak) {
    float highest = 0;
    for (const float s : samples) {
        highest = std::max(highest, std::abs(s));
    }
    if (highest > 0) {
        for (float& s : samples) {
            s *= static_cast<float>(peak) / highest;
        }
    }
}

}  // namespace

std::uint32_t Noise::word() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005u + 1442695040888963407u;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
    const auto turn = static_cast<std::uint32_t>(old >> 59u);
    return mixed >> turn | mixed << (32u - turn) % 32u;
}

Filter::Filter(Kind kind, double hz, double q) {
    const double w = kTurn * hz / kSampleRate, c = std::cos(w), alpha = std::sin(w) / (2 * q);
    const double a0 = 1 + alpha;
    a1_ = -2 * c / a0;
    a2_ = (1 - alpha) / a0;
    switch (kind) {
        case Kind::low:
            b0_ = b2_ = 0.5 * (1 - c) / a0;
            b1_ = (1 - c) / a0;
            break;
        case Kind::high:
            b0_ = b2_ = 0.5 * (1 + c) / a0;
            b1_ = -(1 + c) / a0;
            break;
        case Kind::band:
            b0_ = alpha / a0;
            b1_ = 0;
            b2_ = -alpha / a0;
            break;
    }
}

double Filter::next(double in) {
    const double out = b0_ * in + b1_ * x1_ + b2_ * x2_ - a1_ * y1_ - a2_ * y2_;
    x2_ = x1_;
    x1_ = in;
    y2_ = y1_;
    y1_ = out;
    return out;
}

void add(Samples& out, const Tone& tone) {
    double phase = 0;
    const double length = tone.attack + tone.decay;
    for (std::size_t i = samples_in(tone.at); i < out.size(); ++i) {
        const double t = static_cast<double>(i) / kSampleRate - tone.at;
        if (t > length) {
            break;
        }
        out[i] += static_cast<float>(tone.level * envelope(t, tone.attack, tone.decay) * std::sin(phase));
        phase += kTurn * tone.hz * std::pow(tone.glide, t / length) / kSampleRate;
    }
}

void add(Samples& out, const Burst& burst) {
    Noise noise(burst.seed);
    Filter band(Filter::Kind::band, burst.hz, burst.q);
    // A narrow band lets less through: as loud at any width.
    const double level = burst.level * std::sqrt(burst.q * kSampleRate / burst.hz / 8);
    for (std::size_t i = samples_in(burst.at); i < out.size(); ++i) {
        const double t = static_cast<double>(i) / kSampleRate - burst.at;
        if (t > burst.attack + burst.decay) {
            break;
        }
        out[i] +=
            static_cast<float>(level * envelope(t, burst.attack, burst.decay) * band.next(noise.next()));
    }
}

void finish(Samples& samples, double peak) {
    constexpr double kIn = 0.002, kOut = 0.02;  // seconds
    take_out_constant(samples);
    const std::size_t in = std::min(samples_in(kIn), samples.size());
    const std::size_t out = std::min(samples_in(kOut), samples.size());
    for (std::size_t i = 0; i < in; ++i) {
        samples[i] *= static_cast<float>(i) / static_cast<float>(in);
    }
    for (std::size_t i = 0; i < out; ++i) {
        samples[samples.size() - 1 - i] *= static_cast<float>(i) / static_cast<float>(out);
    }
    scale_to(samples, peak);
}

void finish_loop(Samples& samples, double seconds, double peak) {
    const std::size_t overlap = std::min(samples_in(seconds), samples.size() / 2);
    const std::size_t length = samples.size() - overlap;
    for (std::size_t i = 0; i < overlap; ++i) {
        // Of noise the powers add up.
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(overlap);
        samples[i] = static_cast<float>(std::sqrt(share) * static_cast<double>(samples[i]) +
                                        std::sqrt(1 - share) * static_cast<double>(samples[length + i]));
    }
    samples.resize(length);
    take_out_constant(samples);
    scale_to(samples, peak);
}

}  // namespace lanthorn::audio
