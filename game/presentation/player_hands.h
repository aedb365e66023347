// What the devices do in play: the steps' input, and what of it the simulation knows nothing of.
#pragma once

#include <cstdint>
#include <utility>

#include "game/level/hints.h"
#include "game/rules/player_input.h"
#include "game/screens/lessons.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/input/devices.h"

namespace lanthorn::game {

class PlayerHands {
  public:
    // Of a frame: which device is used, and time for the hint that is shown.
    void pass(const input::Controls& controls, double seconds);
    // Of a step in `world`.
    PlayerInput take(input::Devices& devices, const ecs::World& world);
    // Of a step that the player is only to look on in: what she does is not for her. It is taken all the
    // same.
    void look_on(input::Devices& devices) { devices.take(); }
    // Another level comes.
    void forget() {
        hints_.forget();
        turning_ = false;
    }
    // What is turned while `use` is held turns from one press to the next.
    void set_hold_by_press(bool on) { hold_by_press_ = on; }

    bool takes_reset() { return std::exchange(wants_reset_, false); }  // since the call before
    bool uses_pad() const { return uses_pad_; }                        // last
    const Hints& hints() const { return hints_; }
    Doing done() { return std::exchange(done_, {}); }  // since the call before

  private:
    std::uint16_t hold(std::uint16_t held, bool walks, const ecs::World& world);

    Hints hints_;
    Doing done_;
    std::uint16_t held_ = 0;  // buttons of the step before
    bool wants_reset_ = false;
    bool uses_pad_ = false;
    bool hold_by_press_ = false;
    bool turning_ = false;           // by a press
    std::uint16_t really_held_ = 0;  // in the step before
};

}  // namespace lanthorn::game
