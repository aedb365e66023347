#include "game/presentation/sound/captions.h"

#include <algorithm>
#include <string_view>

namespace lanthorn::game {

namespace {

// Null: nothing to be read.
const char* words_of(audio::Kind kind) {
    switch (static_cast<SoundKind::Name>(kind)) {
        case SoundKind::take:
            return "the lantern is taken";
        case SoundKind::put_down:
            return "the lantern is put down";
        case SoundKind::lantern_on:
            return "a flame flares up";
        case SoundKind::lantern_off:
            return "a flame goes out";
        case SoundKind::glass:
            return "glass clinks";
        case SoundKind::door_shut:
            return "a door falls shut";
        case SoundKind::shutter_stops:
            return "a shutter knocks";
        case SoundKind::crystal_wakes:
            return "a crystal rings";
        case SoundKind::solved:
            return "a chord of bells";
        case SoundKind::door_moves:
            return "a door creaks";
        case SoundKind::shutter_slides:
            return "a shutter slides";
        case SoundKind::pushed:
            return "wood grates on stone";
        case SoundKind::turned:
            return "a stand grinds round";
        case SoundKind::crystal_charges:
            return "a crystal hums, higher and higher";
        default:
            return nullptr;
    }
}

}  // namespace

void Captions::hear(const Heard& heard) {
    const auto add = [&](const Sound& sound) {
        const char* words = words_of(sound.kind);
        if (words == nullptr) {
            return;
        }
        const auto same = std::ranges::find(lines_, std::string_view(words), &Line::words);
        if (same != lines_.end()) {
            same->left = kShownSeconds;
            return;
        }
        lines_.push_back({words, kShownSeconds});
        if (lines_.size() > kMost) {
            lines_.erase(lines_.begin());
        }
    };
    std::ranges::for_each(heard.begun, add);
    std::ranges::for_each(heard.going, add);
}

void Captions::pass(double seconds) {
    for (Line& line : lines_) {
        line.left -= seconds;
    }
    std::erase_if(lines_, [](const Line& line) { return line.left <= 0; });
}

std::vector<std::string> Captions::lines() const {
    std::vector<std::string> words;
    for (const Line& line : lines_) {
        words.emplace_back(line.words);
    }
    return words;
}

}  // namespace lanthorn::game
