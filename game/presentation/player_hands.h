// What the devices do in play: the steps' input, and what of it the simulation knows nothing of.
#pragma once

#include <cstdint>
#include <utility>

#include "game/level/hints.h"
#include "game/rules/player_input.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/input/devices.h"

namespace lanthorn::game {

class PlayerHands {
  public:
    // Of a frame: which device is used, and time for the hint that is shown.
    void pass(const input::Controls& controls, double seconds);
    // Of a step in `world`.
    PlayerInput take(input::Devices& devices, const ecs::World& world);
    // Another level comes.
    void forget() { hints_.forget(); }

    bool takes_reset() { return std::exchange(wants_reset_, false); }  // since the call before
    bool uses_pad() const { return uses_pad_; }                        // last
    const Hints& hints() const { return hints_; }

  private:
    Hints hints_;
    std::uint16_t held_ = 0;  // buttons of the step before
    bool wants_reset_ = false;
    bool uses_pad_ = false;
};

}  // namespace lanthorn::game
