// The thread of the game: two lines before each room, and two after the last.
#pragma once

#include <cstdint>
#include <string_view>

namespace lanthorn::game {

// Of the level of that stem (campaign()), in English; empty: it has none.
std::string_view story_of(std::string_view stem);

// For how many steps of play a level's story stands on the picture: ten seconds.
inline constexpr std::uint64_t kStorySteps = 600;

// When every room is solved.
inline constexpr std::string_view kEnding =
    "Every window of the tower is lit.\nFar out, the first ship turns towards it.";

}  // namespace lanthorn::game
