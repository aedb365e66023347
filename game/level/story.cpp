#include "game/level/story.h"

#include <algorithm>
#include <array>
#include <utility>

namespace lanthorn::game {

namespace {

using Told = std::pair<std::string_view, std::string_view>;

constexpr std::array kStory = {
    Told{"red-wall",
         "The tower is dark, and its keeper has gone down to the sea.\n"
         "Nine rooms, nine windows. You have one lantern."},
    Told{"shutter", "The moon knocks at every shutter up here.\nSomebody small has waited for you to open."},
    Told{"green-screen",
         "One lamp was left burning, with nobody to turn it.\n"
         "What stands beside its way may help it on."},
    Told{"two-glasses",
         "The keeper loved red windows and blue ones.\nHe took the windows along. The glass is here."},
    Told{"mirrors", "Light was too dear to waste it on corners.\nSo the keeper taught it to turn."},
    Told{"pool", "They carried water up two hundred steps.\nNot to drink: to see it on a wall."},
    Told{"burning-glass",
         "The great lens has come down from the top of the tower.\n"
         "Ships have steered by what it gathered."},
    Told{"lamp-bearer",
         "Somebody has kept a light all the while, and tells nobody why.\n"
         "Somebody that small fits behind a corner."},
    Told{"other-light",
         "Across the bay another tower is lit. Its light goes by, and comes again.\n"
         "It looks for an answer."},
};

}  // namespace

std::string_view story_of(std::string_view stem) {
    const auto found = std::ranges::find(kStory, stem, &Told::first);
    return found == kStory.end() ? std::string_view() : found->second;
}

}  // namespace lanthorn::game
