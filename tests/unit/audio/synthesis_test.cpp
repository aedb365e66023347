// What sounds are made of, as numbers.
#include "lanthorn/audio/synthesis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lanthorn::audio {
namespace {

double peak(const Samples& samples) {
    double highest = 0;
    for (const float s : samples) {
        highest = std::max(highest, std::abs(static_cast<double>(s)));
    }
    return highest;
}

// A straight line of noise that is cut off would jump by its whole height where it begins again.
TEST(Synthesis, ALoopHasNoSeam) {
    Samples ramp(samples_in(0.5));
    for (std::size_t i = 0; i < ramp.size(); ++i) {
        ramp[i] = static_cast<float>(i) / static_cast<float>(ramp.size());
    }
    finish_loop(ramp, 0.1, 0.5);
    EXPECT_EQ(ramp.size(), samples_in(0.5) - samples_in(0.1));
    EXPECT_LT(std::abs(ramp.front() - ramp.back()), 0.01f);
    EXPECT_NEAR(peak(ramp), 0.5, 1e-6);
}

// A band lets through what is within it, and next to nothing of what is two octaves away.
TEST(Synthesis, AFilterPassesItsBand) {
    const auto passed = [](Filter filter, double hz) {
        double highest = 0;
        for (int i = 0; i < kSampleRate; ++i) {
            const double out = filter.next(std::sin(6.283185307179586 * hz * i / kSampleRate));
            highest = i > kSampleRate / 2 ? std::max(highest, std::abs(out)) : 0;
        }
        return highest;
    };
    EXPECT_NEAR(passed(Filter(Filter::Kind::band, 800, 4), 800), 1, 0.01);
    EXPECT_LT(passed(Filter(Filter::Kind::band, 800, 4), 3200), 0.1);
    EXPECT_NEAR(passed(Filter(Filter::Kind::low, 800, 0.7), 100), 1, 0.02);
    EXPECT_LT(passed(Filter(Filter::Kind::low, 800, 0.7), 6400), 0.03);
    EXPECT_NEAR(passed(Filter(Filter::Kind::high, 800, 0.7), 6400), 1, 0.02);
}

}  // namespace
}  // namespace lanthorn::audio
