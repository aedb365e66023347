#include "game/rules/figures.h"

#include "lanthorn/ecs/registry.h"

namespace lanthorn::game {

using ecs::field;

void declare_figures(ecs::Registry& registry) {
    registry.component<Figure>(
        "figure", "a skinned figure that walks by its file's clips",
        field("idle", &Figure::idle).words("the clip it stands by"),
        field("walk", &Figure::walk).words("the clip it walks by"),
        field("stride", &Figure::stride).unit("m").more_than(0, 10).words("that a round of walk covers"),
        field("yaw", &Figure::yaw).runtime().unit("rad").words("0 faces -Z, positive to the left"),
        field("turning", &Figure::turning).runtime().words("on the spot"),
        field("place", &Figure::place).runtime().unit("m"),
        field("velocity", &Figure::velocity).runtime().unit("m/s"),
        field("pace", &Figure::pace).runtime().unit("m/s").words("that it walks at; negative: backwards"),
        field("walking", &Figure::walking).runtime().range(0, 1).words("how much of walk shows"));
    registry.component<Hand>(
        "hand", "carries a lantern", field("idle", &Hand::idle).words("with the figure's"),
        field("walk", &Hand::walk).words("likewise"), field("reach", &Hand::reach).words("holds it out"),
        field("close", &Hand::close).words("holds it near the body"),
        field("out", &Hand::out).unit("m").words("from the figure's feet, where reach has it"),
        field("carrying", &Hand::carrying).runtime().range(0, 1),
        field("room", &Hand::room).runtime().range(0, 1).words("of the way out"),
        field("figure", &Hand::figure).runtime());
    registry.component<FollowCamera>(
        "follow_camera", "looks where the player looks",
        field("distance", &FollowCamera::distance).unit("m").range(0, 20).words("behind her"),
        field("aside", &FollowCamera::aside).unit("m").range(-2, 2).words("to the right"),
        field("above", &FollowCamera::above).unit("m").range(-1, 2).words("higher than her eyes"),
        field("ahead", &FollowCamera::ahead).unit("m").range(0, 1).words("before her axis, as her eyes"),
        field("first_person", &FollowCamera::first_person).words("as the level begins"),
        field("side", &FollowCamera::side).runtime().range(-1, 1).words("of her, that it is on"),
        field("beside", &FollowCamera::beside).runtime().unit("m").words("as it is"),
        field("back", &FollowCamera::back).runtime().unit("m").words("as it is"));
    registry.component<Follower>(
        "follower", "comes after the player",
        field("near", &Follower::near).unit("m").range(0, 100).words("where it stops"),
        field("far", &Follower::far).unit("m").range(0, 100).words("from where on it follows"),
        field("speed", &Follower::speed).unit("m/s").range(0, 10).words("that it walks at"),
        field("radius", &Follower::radius).unit("m").more_than(0, 2).words("of the room that it takes"),
        field("follows", &Follower::follows).runtime(),
        field("velocity", &Follower::velocity).runtime().unit("m/s"),
        field("trail", &Follower::trail).runtime().unit("m").words("where she walked since it saw her"));
    registry.component<Heeds>("heeds", "beside a follower: waits where it is told to, by use",
                              field("waits", &Heeds::waits).words("as the level begins"));
}

}  // namespace lanthorn::game
