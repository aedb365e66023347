// What a suite did, in numbers that may not fall: a green run proves that it ran.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

struct Receipt {
    std::uint64_t replays = 0;    // that were judged
    std::uint64_t steps = 0;      // that were compared
    std::uint64_t hashes = 0;     // that were compared
    std::uint64_t parts = 0;      // of the state, that change in some replay
    std::uint64_t systems = 0;    // of a step, that run in some replay
    std::uint64_t pictures = 0;   // that were compared
    std::uint64_t mutants = 0;    // that were made and caught by name
    std::uint64_t blemishes = 0;  // faults of pictures, likewise

    bool operator==(const Receipt&) const = default;
};

// A count of the receipt, by its name in files.
struct Count {
    const char* name;
    std::uint64_t Receipt::*member;
};
inline constexpr Count kCounts[] = {{"replays", &Receipt::replays}, {"steps", &Receipt::steps},
                                    {"hashes", &Receipt::hashes},   {"parts", &Receipt::parts},
                                    {"systems", &Receipt::systems}, {"pictures", &Receipt::pictures},
                                    {"mutants", &Receipt::mutants}, {"blemishes", &Receipt::blemishes}};

// What a run was asked for beside states; counts of the rest are not held against a ratchet, and stay in it.
struct Asked {
    bool mutants = false;   // that faults are made
    bool pictures = false;  // that pictures are compared

    bool of(const Count& count) const;
};

// Of the results of a run, of any kind.
Receipt receipt_of(const std::vector<Result>& results);

inline constexpr const char* kRatchetFile = "ratchet.json";

// The counts that a suite had, beside its recordings.
struct Ratchet {
    Receipt least;
    std::string reason;  // why some are fewer than before; may be empty
    bool there = false;  // the file
};

// Throws InputError for a file that is none. One that is absent is not `there`; one without
// blemishes is of a version that made none.
Ratchet read_ratchet(const std::filesystem::path& folder);

// One line for each count that was asked for and is below the ratchet's, or one if there is no ratchet;
// empty: it holds.
std::vector<std::string> slips(const Receipt& now, const Ratchet& ratchet, const Asked& asked);

// Writes the counts of this run; those that were not asked for stay. Counts that would fall need a reason,
// else throws InputError that names them.
void write_ratchet(const std::filesystem::path& folder, const Receipt& now, const Asked& asked,
                   const std::string& reason);

}  // namespace lanthorn::suite
