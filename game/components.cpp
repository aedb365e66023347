#include "game/components.h"

#include "lanthorn/core/turns.h"
#include "lanthorn/ecs/registry.h"

namespace lanthorn::game {

using ecs::field;

dvec3 Eyes::facing() const {
    const SineCosine turn = sine_cosine(yaw);
    return {-turn.sine, 0, -turn.cosine};
}

quat Lantern::rotation() const {
    // It hangs from its upper end: turned about +Z that end stays and the lower one goes to +X, about -X to
    // +Z.
    return quat(about_z(sway.x)) * quat(about_x(-sway.y)) * quat(about_y(yaw));
}

void declare_components(ecs::Registry& registry) {
    registry.component<Player>("player", "a character that the player moves",
                               field("velocity", &Player::velocity).unit("m/s").words("that she walks at"),
                               field("held", &Player::held).words("buttons down in the last step"));
    registry.component<Eyes>(
        "eyes", "the camera that the player sees with",
        field("yaw", &Eyes::yaw).unit("rad").words("0 looks along -Z, positive to the left"),
        field("pitch", &Eyes::pitch).unit("rad").words("up"));
    registry.component<Door>(
        "door", "a leaf that turns about its node's +Y",
        field("open_angle", &Door::open_angle).unit("rad").range(-kPi, kPi).words("how far it opens"),
        field("angle", &Door::angle).unit("rad").words("how far it is open"),
        field("speed", &Door::speed).unit("rad/s"),
        field("open", &Door::open).words("whether it is open, or on its way"),
        field("closed", &Door::closed).words("the node's rotation at angle 0"));
    registry.component<Lantern>(
        "lantern", "a light that can be carried",
        field("handle", &Lantern::handle).unit("m").range(0, 10).words("from its origin up to the hand"),
        field("carried", &Lantern::carried), field("lit", &Lantern::lit),
        field("yaw", &Lantern::yaw).unit("rad"),
        field("sway", &Lantern::sway).unit("rad").words("towards +X and +Z"),
        field("sway_speed", &Lantern::sway_speed).unit("rad/s"),
        field("hand", &Lantern::hand).unit("m").words("what it hangs from"),
        field("hand_velocity", &Lantern::hand_velocity).unit("m/s"),
        field("flame", &Lantern::flame).words("the node of its light"),
        field("light", &Lantern::light).words("of the flame when it is lit"));
    registry.component<Goal>("goal", "reached once the light sensor beside it reads enough",
                             field("lux", &Goal::lux).unit("lux").range(0, 1e9).words("that are enough"),
                             field("reached", &Goal::reached));
}

}  // namespace lanthorn::game
