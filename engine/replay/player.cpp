#include "lanthorn/replay/player.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lanthorn/core/error.h"

namespace lanthorn::replay {

std::string Divergence::describe() const {
    return fmt::format("step {}: {}: expected hash {:016x}, found {:016x}", step, part, expected, actual);
}

Player::Player(const std::string& file, Recording recording, const RecordingHeader& header)
    : recording_(std::move(recording)) {
    const RecordingHeader& recorded = recording_.header;
    const auto fail = [&](const char* place, const auto& found, const auto& expected) {
        throw InputError(file, place,
                         fmt::format("recorded with {}, but this program has {}", found, expected));
    };
    if (recorded.level != header.level) {
        fail("level", recorded.level, header.level);
    }
    if (recorded.level_hash != header.level_hash) {
        fail("level", fmt::format("contents {:016x} of {}", recorded.level_hash, header.level),
             fmt::format("{:016x}", header.level_hash));
    }
    if (recorded.step_rate != header.step_rate) {
        fail("step_rate", recorded.step_rate, header.step_rate);
    }
    if (recorded.input_format != header.input_format || recorded.input_size != header.input_size) {
        fail("input_format", fmt::format("{} ({} bytes)", recorded.input_format, recorded.input_size),
             fmt::format("{} ({} bytes)", header.input_format, header.input_size));
    }
    if (recorded.parts != header.parts) {
        fail("parts", fmt::format("{}", fmt::join(recorded.parts, " ")),
             fmt::format("{}", fmt::join(header.parts, " ")));
    }
    if (recorded.sensors != header.sensors) {
        fail("sensors", fmt::format("{}", fmt::join(recorded.sensors, " ")),
             fmt::format("{}", fmt::join(header.sensors, " ")));
    }
}

bool Player::check(std::span<const std::uint64_t> hashes) {
    assert(!done() && hashes.size() == recording_.header.parts.size());
    const auto& expected = recording_.steps[next_].hashes;
    for (std::size_t i = 0; i < hashes.size() && !divergence_; ++i) {
        if (hashes[i] != expected[i]) {
            divergence_ = Divergence{next_, recording_.header.parts[i], expected[i], hashes[i]};
        }
    }
    ++next_;
    return !divergence_;
}

}  // namespace lanthorn::replay
