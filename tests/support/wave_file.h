// What came out of the loudspeakers, for tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "lanthorn/audio/samples.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::support {

// OpenAL Soft's settings (alsoft.conf) for its driver `wave`: what would be heard is written into `file`.
inline std::string write_to(const std::string& file) {
    return "channels = stereo\nhrtf = false\nfrequency = 44100\n[wave]\nfile = " + file + "\n";
}

// What was written. Sides: 0 left, 1 right; moments in seconds. Nothing if the file is none.
class WaveFile {
  public:
    explicit WaveFile(const std::string& file) {
        const std::string bytes = testing_tools::file_bytes(file);
        const std::size_t data = bytes.find("data");
        if (bytes.size() < 64 || data == std::string::npos) {
            return;
        }
        std::uint16_t format[8];
        std::memcpy(format, bytes.data() + bytes.find("fmt ") + 8, sizeof format);
        EXPECT_EQ(format[1], 2) << "channels";
        const std::size_t width = format[7] / 8u;
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
    double seconds() const { return static_cast<double>(samples_.size()) / 2 / audio::kSampleRate; }
    // Root of the mean square.
    double loud(int side, double from, double to) const {
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = audio::samples_in(from);
             i < audio::samples_in(to) && 2 * i + 1 < samples_.size(); ++i) {
            sum += std::pow(samples_[2 * i + static_cast<std::size_t>(side)], 2);
            ++count;
        }
        return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
    }
    // When one side is first louder than `level`; the end if never.
    double first(int side, double level) const {
        for (std::size_t i = static_cast<std::size_t>(side); i < samples_.size(); i += 2) {
            if (std::abs(samples_[i]) > level) {
                return static_cast<double>(i / 2) / audio::kSampleRate;
            }
        }
        return seconds();
    }

  private:
    std::vector<double> samples_;  // left and right in turn
};

}  // namespace lanthorn::support
