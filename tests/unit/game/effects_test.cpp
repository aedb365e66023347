// Effects and music as numbers.
#include "game/presentation/sound/effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "game/presentation/sound/music.h"

namespace lanthorn::game {
namespace {

using audio::Samples;
using audio::samples_in;

double peak(const Samples& samples) {
    double highest = 0;
    for (const float s : samples) {
        highest = std::max(highest, std::abs(static_cast<double>(s)));
    }
    return highest;
}

double largest_jump(const Samples& samples) {
    double largest = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        largest = std::max(largest,
                           std::abs(static_cast<double>(samples[i]) - static_cast<double>(samples[i - 1])));
    }
    return largest;
}

Samples music(std::uint64_t seed, double seconds, std::size_t cut) {
    Music piece(seed);
    Samples out(2 * samples_in(seconds));
    for (std::size_t at = 0; at < out.size(); at += 2 * cut) {
        piece.next(std::span(out).subspan(at, std::min(2 * cut, out.size() - at)));
    }
    return out;
}

TEST(Effects, AreTheSameEveryTimeAndWithinBounds) {
    std::set<Samples> all;
    for (int i = 0; i < kSoundKinds; ++i) {
        const Samples samples = synthesise(static_cast<SoundKind::Name>(i));
        EXPECT_EQ(samples, synthesise(static_cast<SoundKind::Name>(i))) << i;
        EXPECT_TRUE(std::ranges::all_of(samples, [](float s) { return std::isfinite(s); })) << i;
        EXPECT_GT(peak(samples), 0.2) << i;
        EXPECT_LT(peak(samples), 0.9) << i;
        EXPECT_GT(samples.size(), samples_in(0.1)) << i;
        EXPECT_LT(samples.size(), samples_in(4)) << i;
        all.insert(samples);
    }
    EXPECT_EQ(all.size(), static_cast<std::size_t>(kSoundKinds));
}

TEST(Effects, DoNotClickAtTheirEnds) {
    for (int i = 0; i < kSoundKinds; ++i) {
        const auto kind = static_cast<SoundKind::Name>(i);
        const Samples samples = synthesise(kind);
        if (goes_on(kind)) {
            // From the end to the beginning as from any sample to the next.
            EXPECT_LE(std::abs(samples.front() - samples.back()), largest_jump(samples)) << i;
        } else {
            EXPECT_LT(std::abs(samples.front()), 1e-3f) << i;
            EXPECT_LT(std::abs(samples.back()), 1e-3f) << i;
        }
    }
}

TEST(Music, IsTheSameHoweverItIsCut) {
    const Samples whole = music(5, 12, samples_in(12));
    EXPECT_EQ(whole, music(5, 12, 441));
    EXPECT_NE(whole, music(6, 12, 441));
}

TEST(Music, IsQuietWithoutClicksAndNeverEnds) {
    const Samples piece = music(1, 90, 4096);
    EXPECT_TRUE(std::ranges::all_of(piece, [](float s) { return std::isfinite(s); }));
    EXPECT_LT(peak(piece), 0.5);
    EXPECT_GT(peak(piece), 0.05);
    for (std::size_t side = 0; side < 2; ++side) {
        Samples channel;
        for (std::size_t i = side; i < piece.size(); i += 2) {
            channel.push_back(piece[i]);
        }
        EXPECT_LT(largest_jump(channel), 0.05);
        // Something sounds in every ten seconds.
        for (std::size_t at = 0; at + samples_in(10) <= channel.size(); at += samples_in(10)) {
            const auto begin = channel.begin() + static_cast<std::ptrdiff_t>(at);
            EXPECT_GT(peak(Samples(begin, begin + static_cast<std::ptrdiff_t>(samples_in(10)))), 0.02) << at;
        }
    }
}

}  // namespace
}  // namespace lanthorn::game
