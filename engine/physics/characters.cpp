// Characters: made, and moved after the bodies.
#include "lanthorn/physics/bullet_types.h"
#include "lanthorn/physics/physics_state.h"

namespace lanthorn::physics {

void Physics::State::add_character(ecs::World& w, ecs::Entity e, const CharacterDescription& description) {
    const dvec3 feet(current_matrix(w, e)[3]);
    if (!is_finite(feet)) {
        warn(w, e, "has a transform that is not finite, expected a place to stand: skipped");
        return;
    }
    join(feet);
    Character& c = characters[e.index];
    c.entity = e;
    c.description = description;
    c.feet = feet - origin;
    c.state = {};
    c.written = w.get<LocalTransform>(e).value;
    c.shape =
        std::make_unique<btCapsuleShape>(description.radius, description.height - 2 * description.radius);
    c.object = std::make_unique<btCollisionObject>();
    c.object->setCollisionShape(c.shape.get());
    c.object->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    c.object->setActivationState(DISABLE_DEACTIVATION);
    c.motion = std::make_unique<CharacterMotion>(world, *c.object, description);
    c.object->setWorldTransform(bt(c.feet + dvec3(0, 0.5 * description.height, 0), {1, 0, 0, 0}));
    world.addCollisionObject(c.object.get(), btBroadphaseProxy::KinematicFilter);
    w.insert(e, CharacterState{});
}

void Physics::State::move_character(ecs::World& w, Character& c) {
    if (!(w.get<LocalTransform>(c.entity).value == c.written)) {
        const dvec3 feet(current_matrix(w, c.entity)[3]);
        if (is_finite(feet)) {
            c.feet = feet - origin;
            c.state = {};
        } else {
            warn(w, c.entity,
                 "was given a transform that is not finite, expected numbers: stays where it was");
        }
    }
    CharacterInput input;
    if (const CharacterInput* given = w.try_get<CharacterInput>(c.entity)) {
        if (is_finite(given->velocity)) {
            input = *given;
        } else {
            warn(w, c.entity, "was given a velocity that is not finite, expected numbers: stands still");
        }
    }
    c.feet = c.motion->step(c.feet, input, -settings.gravity.y, settings.time_step, c.state);
    c.object->setWorldTransform(bt(c.feet + dvec3(0, 0.5 * c.description.height, 0), {1, 0, 0, 0}));
    world.updateSingleAabb(c.object.get());

    Transform local = w.get<LocalTransform>(c.entity).value;
    local.translation = local_of(w, c.entity, c.feet + origin, {1, 0, 0, 0}).translation;
    if (!(local == w.get<LocalTransform>(c.entity).value)) {
        w.get_mut<LocalTransform>(c.entity).value = local;
    }
    c.written = local;
    if (const CharacterState* told = w.try_get<CharacterState>(c.entity);
        told == nullptr || *told != c.state) {
        w.insert(c.entity, CharacterState(c.state));
    }
}

void Physics::State::remove_character(std::uint32_t index) {
    const auto found = characters.find(index);
    world.removeCollisionObject(found->second.object.get());
    characters.erase(found);
}

}  // namespace lanthorn::physics
