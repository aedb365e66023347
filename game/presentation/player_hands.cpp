#include "game/presentation/player_hands.h"

#include "game/rules/actions.h"
#include "game/rules/components.h"

namespace lanthorn::game {

void PlayerHands::pass(const input::Controls& controls, double seconds) {
    for (const input::Trigger trigger : controls.pressed()) {
        uses_pad_ = trigger.device == input::Trigger::Device::pad;
    }
    hints_.pass(seconds);
}

PlayerInput PlayerHands::take(input::Devices& devices, const ecs::World& world) {
    const PlayerInput input = player_input(devices.take());
    const std::uint16_t fresh = static_cast<std::uint16_t>(input.held & ~std::exchange(held_, input.held));
    if ((fresh & kHint) != 0) {
        hints_.ask(level_info(world).hints);
    }
    wants_reset_ = wants_reset_ || (fresh & kReset) != 0;
    return input;
}

}  // namespace lanthorn::game
