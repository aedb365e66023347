// What comes out of the machine: OpenAL Soft writes it into a file instead of a device. Its settings are read
// once a process, so each test listens in a process of its own.
#include "game/sound/speaker.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <thread>

#include "game/sound/samples.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::game {
namespace {

using namespace std::chrono_literals;

constexpr auto kPause = 400ms;

class SpeakerTest : public testing::Test {
  protected:
    // The exit code of a process in which `drivers` are OpenAL's, and `use` is called.
    int in_process(const std::string& drivers, const std::function<int(Speaker&)>& use) {
        std::ofstream(folder_.path("alsoft.conf"))
            << "channels = stereo\nhrtf = false\nfrequency = 44100\n[wave]\nfile = " << wave_file() << "\n";
        const pid_t child = ::fork();
        if (child == 0) {
            ::setenv("ALSOFT_CONF", folder_.path("alsoft.conf").c_str(), 1);
            ::setenv("ALSOFT_DRIVERS", drivers.c_str(), 1);
            int code = 0;
            {
                Speaker speaker(1);
                code = use(speaker);
            }
            ::_exit(code);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    std::string wave_file() const { return folder_.path("out.wav"); }

    testing_tools::TemporaryFolder folder_;
};

bool waits_for_device(const Speaker& speaker) {
    for (int i = 0; i < 200 && !speaker.sounds(); ++i) {
        std::this_thread::sleep_for(10ms);
    }
    return speaker.sounds();
}

// Root of the mean square of one side between two moments, in seconds.
class Wave {
  public:
    explicit Wave(const std::string& file) {
        const std::string bytes = testing_tools::file_bytes(file);
        const std::size_t data = bytes.find("data");
        const std::uint16_t* format = nullptr;
        if (bytes.size() < 64 || data == std::string::npos) {
            return;
        }
        format = reinterpret_cast<const std::uint16_t*>(bytes.data() + bytes.find("fmt ") + 8);
        EXPECT_EQ(format[1], 2) << "channels";
        const std::size_t width = format[7] / 8;
        for (std::size_t at = data + 8; at + width <= bytes.size(); at += width) {
            if (width == 4) {
                float value = 0;
                std::memcpy(&value, bytes.data() + at, 4);
                samples_.push_back(static_cast<double>(value));
            } else {
                std::int16_t value = 0;
                std::memcpy(&value, bytes.data() + at, 2);
                samples_.push_back(value / 32768.0);
            }
        }
    }
    double seconds() const { return static_cast<double>(samples_.size()) / 2 / kSampleRate; }
    double loud(int side, double from, double to) const {
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = samples_in(from); i < samples_in(to) && 2 * i + 1 < samples_.size(); ++i) {
            sum += std::pow(samples_[2 * i + static_cast<std::size_t>(side)], 2);
            ++count;
        }
        return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
    }
    // When one side is first louder than `level`; the end if never.
    double first(int side, double level) const {
        for (std::size_t i = static_cast<std::size_t>(side); i < samples_.size(); i += 2) {
            if (std::abs(samples_[i]) > level) {
                return static_cast<double>(i / 2) / kSampleRate;
            }
        }
        return seconds();
    }

  private:
    std::vector<double> samples_;  // left and right in turn
};

Heard step_at(const dvec3& place) {
    Heard heard;
    heard.ears = {{1e5, 1.6, 0}, {0, 0, -1}, {0, 1, 0}};  // also far from the origin
    heard.begun.push_back({.kind = SoundKind::step_left, .place = heard.ears.place + place});
    return heard;
}

TEST_F(SpeakerTest, AStepIsHeardWhereItIs) {
    const int code = in_process("wave", [](Speaker& speaker) {
        speaker.set_volumes(1, 0);
        if (!waits_for_device(speaker)) {
            return 3;
        }
        std::this_thread::sleep_for(kPause);
        speaker.play(step_at({-2, 0, 0}));
        std::this_thread::sleep_for(2 * kPause);
        speaker.play(step_at({2, 0, 0}));
        std::this_thread::sleep_for(2 * kPause);
        return 0;
    });
    ASSERT_EQ(code, 0);
    const Wave wave(wave_file());
    const double left = wave.first(0, 0.02), right = wave.first(1, 0.1);
    ASSERT_GT(wave.seconds(), 1.5);
    EXPECT_GT(left, 0.2);
    EXPECT_LT(right, wave.seconds() - 0.2);
    EXPECT_GT(right, left + 0.5);
    EXPECT_EQ(wave.loud(0, 0, left - 0.05), 0) << "silence before it";
    EXPECT_GT(wave.loud(0, left, left + 0.2), 3 * wave.loud(1, left, left + 0.2));
    EXPECT_GT(wave.loud(1, right, right + 0.2), 3 * wave.loud(0, right, right + 0.2));
    EXPECT_LT(wave.loud(1, right - 0.2, right - 0.05), 1e-3) << "it ends";
}

TEST_F(SpeakerTest, FarAwayIsFainter) {
    const int code = in_process("wave", [](Speaker& speaker) {
        speaker.set_volumes(1, 0);
        if (!waits_for_device(speaker)) {
            return 3;
        }
        speaker.play(step_at({-2, 0, 0}));
        std::this_thread::sleep_for(2 * kPause);
        speaker.play(step_at({12, 0, 0}));
        std::this_thread::sleep_for(2 * kPause);
        return 0;
    });
    ASSERT_EQ(code, 0);
    const Wave wave(wave_file());
    const double near = wave.first(0, 0.02);
    const double middle = near + 0.6;
    const double ratio = wave.loud(0, near, middle) / wave.loud(1, middle, wave.seconds());
    EXPECT_GT(ratio, 3);
    EXPECT_LT(ratio, 12);
}

TEST_F(SpeakerTest, WhatGoesOnFadesOutWhenItEnds) {
    const int code = in_process("wave", [](Speaker& speaker) {
        speaker.set_volumes(1, 0);
        if (!waits_for_device(speaker)) {
            return 3;
        }
        Heard heard;
        heard.going.push_back({.kind = SoundKind::pushed, .place = {0, 0, -1}});
        speaker.play(heard);
        std::this_thread::sleep_for(3 * kPause);
        speaker.play({});
        std::this_thread::sleep_for(2 * kPause);
        return 0;
    });
    ASSERT_EQ(code, 0);
    const Wave wave(wave_file());
    const double begin = wave.first(0, 0.02);
    EXPECT_GT(wave.loud(0, begin, begin + 1), 0.02);
    EXPECT_LT(wave.loud(0, wave.seconds() - 0.2, wave.seconds()), 1e-4);
}

TEST_F(SpeakerTest, MusicPlaysAsLoudAsItIsChosen) {
    const auto loud = [&](double volume) {
        const int code = in_process("wave", [volume](Speaker& speaker) {
            speaker.set_volumes(1, volume);
            if (!waits_for_device(speaker)) {
                return 3;
            }
            std::this_thread::sleep_for(5s);
            return 0;
        });
        EXPECT_EQ(code, 0);
        return Wave(wave_file()).loud(0, 2, 4.5);
    };
    const double whole = loud(1), half = loud(0.5);
    EXPECT_GT(whole, 0.005);
    EXPECT_LT(whole, 0.2);
    EXPECT_NEAR(half / whole, 0.5, 0.1);
    EXPECT_EQ(loud(0), 0);
}

TEST_F(SpeakerTest, WithoutADeviceItIsSilentAndInNobodysWay) {
    for (const char* drivers : {"none of these", "null"}) {
        const int code = in_process(drivers, [](Speaker& speaker) {
            const auto began = std::chrono::steady_clock::now();
            for (int i = 0; i < 10'000; ++i) {
                speaker.play(step_at({-2, 0, 0}));
            }
            // Far more than a second of frames; a device would take minutes to play as much.
            return std::chrono::steady_clock::now() - began < 1s ? 0 : 4;
        });
        EXPECT_EQ(code, 0) << drivers;
    }
}

}  // namespace
}  // namespace lanthorn::game
