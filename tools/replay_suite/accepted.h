// Differences that are known and accepted: a file beside the recordings, each by name, with a reason and a
// day until which it holds. What is accepted still runs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

struct Acceptance {
    std::string failure;  // Result::failure
    std::string reason;
    std::string until;  // "2026-12-31", that day included
};

inline constexpr const char* kAcceptedFile = "accepted.json";

// Those of a folder of recordings; none without the file. Throws InputError for a file that is none.
std::vector<Acceptance> read_accepted(const std::filesystem::path& folder);
// Puts one in, instead of an earlier one of the same failure. Throws InputError for a day that is none or
// has passed, an empty reason, or a file that cannot be written.
void accept(const std::filesystem::path& folder, const Acceptance& acceptance, std::string_view today);

// "2026-11-26" of the present day, UTC.
std::string today();
// Whether it is a day of the calendar in that form.
bool is_day(std::string_view text);

// The name of the recording in a failure's: "pool.rec" of "pool.rec-1a2b3c".
std::string recording_of(const std::string& failure);

}  // namespace lanthorn::suite
