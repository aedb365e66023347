#include "game/presentation/player_hands.h"

#include <cmath>

#include "game/rules/actions.h"
#include "game/rules/components.h"
#include "game/rules/systems.h"
#include "lanthorn/ecs/query.h"

namespace lanthorn::game {

void PlayerHands::pass(const input::Controls& controls, double seconds) {
    for (const input::Trigger trigger : controls.pressed()) {
        uses_pad_ = trigger.device == input::Trigger::Device::pad;
    }
    hints_.pass(seconds);
}

// A press of `use` at a turntable holds it until the next one, or until she walks.
std::uint16_t PlayerHands::hold(std::uint16_t held, bool walks, const ecs::World& world) {
    const bool pressed = (held & kUse & ~std::exchange(really_held_, held)) != 0;
    bool at_hand = false;
    world.query<ecs::With<Turntable>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const WorldTransform& at) {
            const physics::Physics& physics = *world.resource<SharedPhysics>();
            const dvec3 middle = physics.centre(e).value_or(dvec3(at.matrix[3]));
            at_hand = at_hand || world.resource<Intent>().in_reach(middle);
        });
    turning_ = at_hand && !walks && turning_ != pressed;
    if (!at_hand) {
        return held;
    }
    return static_cast<std::uint16_t>(turning_ ? held | kUse : held & ~kUse);
}

PlayerInput PlayerHands::take(input::Devices& devices, const ecs::World& world) {
    const input::Step step = devices.take();
    PlayerInput input = player_input(step);
    for (std::size_t row = 0; row < kActions; ++row) {
        done_.used[row] = done_.used[row] || step.down[row];
    }
    done_.walked = done_.walked || input.forward != 0 || input.right != 0;
    done_.turned += input::kTurnUnit * std::hypot(input.yaw, input.pitch);
    if (hold_by_press_) {
        input.held = hold(input.held, input.forward != 0 || input.right != 0, world);
    }
    const std::uint16_t fresh = static_cast<std::uint16_t>(input.held & ~std::exchange(held_, input.held));
    if ((fresh & kHint) != 0) {
        hints_.ask(level_info(world).hints);
    }
    wants_reset_ = wants_reset_ || (fresh & kReset) != 0;
    return input;
}

}  // namespace lanthorn::game
