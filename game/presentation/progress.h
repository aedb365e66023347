// How far a player has come: the levels that she has solved, and the one in play as she left it.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/shell/kept_file.h"

namespace lanthorn::game {

struct Progress {
    std::set<std::string> solved;  // levels by their file's name without folder and ending
    std::string level;             // in play, likewise; empty: none
    std::uint64_t level_hash = 0;  // of that level's file
    std::string state;             // of its world, ecs::Snapshot::to_bytes(), by names; empty: its beginning

    bool operator==(const Progress&) const = default;
};

inline constexpr std::uint32_t kProgressVersion = 1;

// As stored: a mark, the version, the length and the xxHash of what follows. And back: throws InputError
// naming `source` for bytes that are none of this, of another version or damaged. What it does not say has
// its default, and what is said besides is passed over.
std::string to_bytes(const Progress& progress);
Progress progress_from_bytes(std::string_view bytes, std::string_view source);

// What is said of a level that another build kept: "FILE: kept by another build; left out: door.swing,
// torch". Of many the first six are named.
std::string left_out_line(std::string_view source, const std::vector<std::string>& left_out);

// The file's, or none; a damaged file is put aside and said.
Progress read_progress(shell::KeptFile& file);

}  // namespace lanthorn::game
