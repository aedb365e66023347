#include "game/rules/components.h"

#include <cmath>

#include "game/rules/cloth.h"
#include "game/rules/figures.h"
#include "game/rules/flames.h"
#include "lanthorn/core/turns.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"

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

Light Lantern::shining() const {
    Light shines = light;
    shines.intensity *= static_cast<float>(std::exp2(double(brightness) - double(kLevels)));
    if (slide > 0 && slide <= slides.size()) {
        shines.colour *= slides[slide - 1];
    }
    return shines;
}

bool solved(const ecs::World& world) {
    bool any = false, all = true;
    world.query<ecs::Read<Crystal>>().each([&](const Crystal& crystal) {
        any = true;
        all = all && crystal.awake;
    });
    world.query<ecs::Read<Goal>>().each([&](const Goal& goal) {
        any = true;
        all = all && goal.reached;
    });
    return any && all;
}

LevelInfo level_info(const ecs::World& world) {
    LevelInfo found;
    world.query<ecs::Read<LevelInfo>>().each([&](const LevelInfo& info) { found = info; });
    return found;
}

namespace {

void declare_moving(ecs::Registry& registry) {
    registry.component<Shutter>(
        "shutter", "a leaf that slides",
        field("way", &Shutter::way).unit("m").words("to where it is open, in its parent's axes"),
        field("seconds", &Shutter::seconds).unit("s").more_than(0, 60).words("that it takes"),
        field("share", &Shutter::share).runtime().range(0, 1).words("of the way"),
        field("open", &Shutter::open).runtime().words("whether it is open, or on its way"),
        field("shut", &Shutter::shut).runtime().unit("m").words("the node's translation where it is shut"));
    registry.component<Pushed>(
        "pushed", "something that the player pushes along a rail",
        field("rail", &Pushed::rail).unit("m").words("to its other end, in its parent's axes"),
        field("share", &Pushed::share).runtime().range(0, 1).words("of the rail"),
        field("start", &Pushed::start)
            .runtime()
            .unit("m")
            .words("the node's translation at the rail's beginning"));
    registry.component<Turntable>(
        "turntable", "turns about its node's +Y while it is used",
        field("speed", &Turntable::speed).unit("rad/s").range(-kPi, kPi).words("while it is used"),
        field("angle", &Turntable::angle).runtime().unit("rad").words("from where it stood"),
        field("start", &Turntable::start).runtime().words("the node's rotation at angle 0"));
}

void declare_crystal(ecs::Registry& registry) {
    registry.component<Crystal>(
        "crystal", "wakes once the light sensor beside it has read enough for long enough",
        field("lux", &Crystal::lux).unit("lux").range(0, 1e9).words("that are enough"),
        field("seconds", &Crystal::seconds).unit("s").range(0, 60).words("of them that wake it"),
        field("symbol", &Crystal::symbol)
            .choices({"circle", "triangle", "square", "star", "moon", "drop"})
            .words("for those who cannot tell colours"),
        field("glow", &Crystal::glow).unit("cd/m^2").range(0, 1e9).words("of its surface, awake"),
        field("charge", &Crystal::charge).runtime().range(0, 1).words("how much has come together"),
        field("awake", &Crystal::awake).runtime(),
        field("glowing", &Crystal::glowing).runtime().range(0, 1).words("how much of its glow shows"),
        field("lamp", &Crystal::lamp).runtime().words("the node of its light"),
        field("light", &Crystal::light).runtime().words("of the lamp, awake"));
}

}  // namespace

void declare_level_info(ecs::Registry& registry) {
    registry.structure(
        "leg", field("go", &Leg::go).unit("m").words("where to stand"),
        field("look", &Leg::look).unit("m").words("what to look at"),
        field("seconds", &Leg::seconds).unit("s").more_than(0, 600),
        field("deed", &Leg::deed).choices({"none", "use", "light", "carry", "brighter", "darker", "colour"}),
        field("hold", &Leg::hold).words("whether the button is down all the while"));
    registry.component<LevelInfo>(
        "level", "what the level is called, and how it is solved", field("title", &LevelInfo::title),
        field("hints", &LevelInfo::hints).words("from the faintest to the plainest"),
        field("tour", &LevelInfo::tour).words("how it is solved"));
}

void declare_components(ecs::Registry& registry) {
    registry.component<Player>(
        "player", "a character that the player moves",
        field("velocity", &Player::velocity).runtime().unit("m/s").words("that she walks at"),
        field("held", &Player::held).runtime().words("buttons down in the last step"));
    registry.component<Eyes>(
        "eyes", "the camera that the player sees with",
        field("yaw", &Eyes::yaw).runtime().unit("rad").words("0 looks along -Z, positive to the left"),
        field("pitch", &Eyes::pitch).runtime().unit("rad").words("up"));
    registry.component<Door>(
        "door", "a leaf that turns about its node's +Y",
        field("open_angle", &Door::open_angle).unit("rad").range(-kPi, kPi).words("how far it opens"),
        field("angle", &Door::angle).runtime().unit("rad").words("how far it is open"),
        field("speed", &Door::speed).runtime().unit("rad/s"),
        field("open", &Door::open).runtime().words("whether it is open, or on its way"),
        field("closed", &Door::closed).runtime().words("the node's rotation at angle 0"));
    registry.component<Lantern>(
        "lantern", "a light that can be carried",
        field("handle", &Lantern::handle).unit("m").range(0, 10).words("from its origin up to the hand"),
        field("carried", &Lantern::carried).runtime(),
        field("lit", &Lantern::lit).words("whether it burns as the level begins"),
        field("yaw", &Lantern::yaw).runtime().unit("rad"),
        field("sway", &Lantern::sway).runtime().unit("rad").words("towards +X and +Z"),
        field("sway_speed", &Lantern::sway_speed).runtime().unit("rad/s"),
        field("hand", &Lantern::hand).runtime().unit("m").words("what it hangs from"),
        field("hand_velocity", &Lantern::hand_velocity).runtime().unit("m/s"),
        field("lift", &Lantern::lift)
            .runtime()
            .range(0, 1)
            .words("of its way from where it was taken to the hand"),
        field("flame", &Lantern::flame).runtime().words("the node of its light"),
        field("light", &Lantern::light).runtime().words("of the flame at its brightest, through no glass"),
        field("slides", &Lantern::slides).range(0, 1).words("what each coloured glass lets through"),
        field("slide", &Lantern::slide).words("which glass is in as the level begins; 0: none"),
        field("brightness", &Lantern::brightness)
            .range(1, Lantern::kLevels)
            .words("as the level begins; each is twice the one before"));
    registry.component<Goal>("goal", "reached once the light sensor beside it reads enough",
                             field("lux", &Goal::lux).unit("lux").range(0, 1e9).words("that are enough"),
                             field("reached", &Goal::reached).runtime());
    declare_moving(registry);
    declare_crystal(registry);
    declare_figures(registry);
    declare_cloth(registry);
    declare_flames(registry);
    declare_level_info(registry);
}

}  // namespace lanthorn::game
