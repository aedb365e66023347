#include "engine/physics/declare_components.h"

#include <fmt/format.h>

#include <limits>

#include "lanthorn/physics/components.h"

namespace lanthorn::physics {
namespace {

using ecs::field;

constexpr double kMost = std::numeric_limits<double>::max();
constexpr double kRightAngle = 0.5 * static_cast<double>(kPi);

std::string wrong_body(const RigidBody& body) {
    return body.collider.shape == BodyShape::mesh && body.type == BodyType::dynamic
               ? "shape is \"mesh\", expected 'convex' or a simple shape for a dynamic body"
               : "";
}

std::string wrong_character(const Character& c) {
    return c.height < 2 * c.radius ? fmt::format("height is {}, expected at least twice the radius", c.height)
                                   : "";
}

void declare_state(ecs::Registry& registry) {
    registry.structure("exact_point", field("whole", &ExactPoint::whole).unit("m").words("integers"),
                       field("rest", &ExactPoint::rest).unit("m"));
    registry
        .component<BodyMotion>(
            "body_motion", "how a dynamic body moves",
            field("linear", &BodyMotion::linear).unit("m/s").words("of the centre of mass"),
            field("angular", &BodyMotion::angular).unit("rad/s"),
            field("position", &BodyMotion::position).words("of the centre of mass in the world"),
            field("rotation", &BodyMotion::rotation).words("in the world"),
            field("still", &BodyMotion::still).unit("s").words("since when it has been still"),
            field("rest", &BodyMotion::rest).choices({"awake", "drowsy", "asleep"}),
            field("local", &BodyMotion::local).words("the transform that position and rotation belong to"))
        .runtime()
        .not_in_extras();
    registry
        .component<CharacterInput>("character_input", "where a character is to go",
                                   field("velocity", &CharacterInput::velocity).unit("m/s"),
                                   field("jump", &CharacterInput::jump))
        .runtime()
        .not_in_extras();
    registry
        .component<CharacterState>(
            "character_state", "how a character is",
            field("vertical_speed", &CharacterState::vertical_speed).unit("m/s"),
            field("on_ground", &CharacterState::on_ground),
            field("feet", &CharacterState::feet).words("where they are in the world"),
            field("local", &CharacterState::local).unit("m").words("the translation that feet belong to"))
        .runtime()
        .not_in_extras();
}

}  // namespace

void declare_physics_components(ecs::Registry& registry) {
    const std::vector<std::string> shapes = {"box", "sphere", "capsule", "convex", "mesh"};
    registry
        .component<Collider>(
            "collider", "what others meet",
            field("shape", &Collider::shape).choices(shapes).words("convex: hull of the meshes"),
            field("friction", &Collider::friction).range(0, kMost).words("a contact has the product of both"),
            field("restitution", &Collider::restitution).range(0, 1).words("likewise"),
            field("size", &Collider::size).unit("m").more_than(0).words("edges of a box"),
            field("radius", &Collider::radius).unit("m").more_than(0).words("of a sphere or capsule"),
            field("height", &Collider::height).unit("m").more_than(0).words("of a capsule, with its caps"),
            field("centre", &Collider::centre).unit("m").words("the bounds' where it is left out"))
        .briefly("shape");
    registry
        .component<RigidBody>(
            "body", "a body that stands, falls or pushes",
            field("type", &RigidBody::type)
                .choices({"static", "dynamic", "kinematic"})
                .words("kinematic: the game moves it"),
            field("mass", &RigidBody::mass).unit("kg").more_than(0).words("of a dynamic body"),
            field("collider", &RigidBody::collider).flat())
        .check(wrong_body);
    registry
        .component<Character>(
            "character", "an upright capsule that walks",
            field("radius", &Character::radius).unit("m").more_than(0).words("of the capsule"),
            field("height", &Character::height).unit("m").more_than(0).words("from the feet to the top"),
            field("stepHeight", &Character::step_height).unit("m").range(0, kMost).words("that a foot lifts"),
            field("slopeLimit", &Character::slope_limit)
                .unit("rad")
                .range(0, kRightAngle)
                .words("that can still be walked on"),
            field("jumpSpeed", &Character::jump_speed).unit("m/s").range(0, kMost).words("at take-off"))
        .check(wrong_character);
    declare_state(registry);
}

}  // namespace lanthorn::physics
