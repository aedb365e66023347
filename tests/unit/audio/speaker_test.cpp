// What comes out of the machine: OpenAL Soft writes it into a file instead of a device. Its settings are read
// once a process, so each test listens in a process of its own.
#include "lanthorn/audio/speaker.h"

#include <AL/alc.h>
#include <AL/alext.h>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <thread>

#include "lanthorn/audio/synthesis.h"
#include "tests/support/wave_file.h"

namespace lanthorn::audio {
namespace {

using namespace std::chrono_literals;

constexpr auto kPause = 400ms;

constexpr Kind kStep = 0, kPushed = 1;

std::vector<Effect> effects() {
    Samples step(samples_in(0.2)), pushed(samples_in(1));
    add(step, Burst{.hz = 600});
    finish(step, 0.8);
    add(pushed, Burst{.hz = 500, .decay = 5});
    finish_loop(pushed, 0.2, 0.5);
    return {{step, false}, {pushed, true}};
}

void hum(std::span<float> stereo) {
    Samples tone(stereo.size() / 2);
    add(tone, Tone{.hz = 220, .decay = 5});
    finish(tone, 0.1);
    for (std::size_t i = 0; i < stereo.size(); ++i) {
        stereo[i] = tone[i / 2];
    }
}

class SpeakerTest : public testing::Test {
  protected:
    // The exit code of a process in which `drivers` are OpenAL's (null: as it chooses), and `use` is called.
    int in_process(const char* drivers, const std::function<int(Speaker&)>& use) {
        std::ofstream(folder_.path("alsoft.conf")) << support::write_to(wave_file());
        const pid_t child = ::fork();
        if (child == 0) {
            ::setenv("ALSOFT_CONF", folder_.path("alsoft.conf").c_str(), 1);
            ::unsetenv("ALSOFT_DRIVERS");
            if (drivers != nullptr) {
                ::setenv("ALSOFT_DRIVERS", drivers, 1);
            }
            int code = 0;
            {
                Speaker speaker({effects, hum});
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

// OpenAL's, as of a device that goes away the first time that it is asked whether it is there. These stand in
// front of the library's own.
std::atomic<bool> goes_away = false;
std::atomic<int> opened = 0;

template <class Function>
Function library(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace
}  // namespace lanthorn::audio

extern "C" void alcGetIntegerv(ALCdevice* device, ALCenum what, ALCsizei size, ALCint* values) {
    using namespace lanthorn::audio;
    library<decltype(&alcGetIntegerv)>("alcGetIntegerv")(device, what, size, values);
    if (what == ALC_CONNECTED && goes_away.exchange(false)) {
        *values = ALC_FALSE;
    }
}

extern "C" ALCdevice* alcOpenDevice(const ALCchar* name) {
    ++lanthorn::audio::opened;
    return lanthorn::audio::library<decltype(&alcOpenDevice)>("alcOpenDevice")(name);
}

namespace lanthorn::audio {
namespace {

TEST_F(SpeakerTest, AnotherDeviceTakesOver) {
    const int code = in_process("null", [](Speaker& speaker) {
        if (!waits_for_device(speaker) || opened != 1) {
            return 3;
        }
        goes_away = true;
        for (int i = 0; i < 200 && opened == 1; ++i) {
            std::this_thread::sleep_for(10ms);
        }
        return opened != 2 ? 4 : waits_for_device(speaker) ? 0 : 5;
    });
    EXPECT_EQ(code, 0);
}

Heard step_at(const dvec3& place) {
    Heard heard;
    heard.ears = {{1e5, 1.6, 0}, {0, 0, -1}, {0, 1, 0}};  // also far from the origin
    heard.begun.push_back({.kind = kStep, .place = heard.ears.place + place});
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
    const support::WaveFile wave(wave_file());
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
    const support::WaveFile wave(wave_file());
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
        heard.going.push_back({.kind = kPushed, .place = {0, 0, -1}});
        speaker.play(heard);
        std::this_thread::sleep_for(3 * kPause);
        speaker.play({});
        std::this_thread::sleep_for(2 * kPause);
        return 0;
    });
    ASSERT_EQ(code, 0);
    const support::WaveFile wave(wave_file());
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
        return support::WaveFile(wave_file()).loud(0, 2, 4.5);
    };
    const double whole = loud(1), half = loud(0.5);
    EXPECT_GT(whole, 0.005);
    EXPECT_LT(whole, 0.2);
    EXPECT_NEAR(half / whole, 0.5, 0.1);
    EXPECT_EQ(loud(0), 0);
}

// Where there is no sound card either; nobody wants to read that every time.
TEST_F(SpeakerTest, ThatThereIsNoDeviceIsNotSaid) {
    if (::access("/dev/snd", F_OK) == 0) {
        GTEST_SKIP() << "there is a sound card";
    }
    testing::internal::CaptureStderr();
    const int code = in_process(nullptr, [](Speaker&) {
        std::this_thread::sleep_for(kPause);
        return 0;
    });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(code, 0);
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
}  // namespace lanthorn::audio
