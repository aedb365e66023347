// Characters: made, and moved after the bodies.
#include "engine/physics/bullet_types.h"
#include "engine/physics/physics_state.h"

namespace lanthorn::physics {

void Physics::State::add_character(const Access& a, ecs::Entity e, const Character& description) {
    if (const std::string wrong = problem_of(description); !wrong.empty()) {
        warn(a.world, e, wrong);
        return;
    }
    const dvec3 feet(current_matrix(a.world, e)[3]);
    if (!is_finite(feet)) {
        warn(a.world, e, "has a transform that is not finite, expected a place to stand: skipped");
        return;
    }
    join(feet);
    Walker& c = characters[e.index];
    c.entity = e;
    c.description = description;
    c.shape =
        std::make_unique<btCapsuleShape>(description.radius, description.height - 2 * description.radius);
    c.object = std::make_unique<btCollisionObject>();
    c.object->setCollisionShape(c.shape.get());
    c.object->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    c.object->setActivationState(DISABLE_DEACTIVATION);
    c.motion = std::make_unique<CharacterMotion>(world, *c.object, description);
    c.object->setWorldTransform(bt(feet - origin + dvec3(0, 0.5 * description.height, 0), {1, 0, 0, 0}));
    world.addCollisionObject(c.object.get(), btBroadphaseProxy::KinematicFilter);
    if (!a.world.has<CharacterState>(e)) {
        const dvec3 local = a.world.get<LocalTransform>(e).value.translation;
        c.told = {.feet = exact_point(feet - origin, origin), .local = local};
        a.put(e, c.told);
    }
}

void Physics::State::move_character(const Access& a, Walker& c) {
    const CharacterState* known = a.world.try_get<CharacterState>(c.entity);
    CharacterState state = known != nullptr ? *known : c.told;
    if (!(a.world.get<LocalTransform>(c.entity).value.translation == state.local)) {
        const dvec3 feet(current_matrix(a.world, c.entity)[3]);
        if (is_finite(feet)) {
            state = {.feet = exact_point(feet - origin, origin)};
        } else {
            warn(a.world, c.entity,
                 "was given a transform that is not finite, expected numbers: stays where it was");
        }
    }
    CharacterInput input;
    if (const CharacterInput* given = a.world.try_get<CharacterInput>(c.entity)) {
        if (is_finite(given->velocity)) {
            input = *given;
        } else {
            warn(a.world, c.entity,
                 "was given a velocity that is not finite, expected numbers: stands still");
        }
    }
    const dvec3 feet = c.motion->step(relative_to(origin, state.feet), input, -settings.gravity.y,
                                      settings.time_step, state);
    state.feet = exact_point(feet, origin);
    c.object->setWorldTransform(bt(feet + dvec3(0, 0.5 * c.description.height, 0), {1, 0, 0, 0}));
    world.updateSingleAabb(c.object.get());

    state.local = local_of(a.world, c.entity, feet + origin, {1, 0, 0, 0}).translation;
    if (!(state.local == a.world.get<LocalTransform>(c.entity).value.translation)) {
        a.writes.try_get_mut<LocalTransform>(c.entity)->value.translation = state.local;
    }
    c.told = state;
    if (known == nullptr || *known != state) {
        a.put(c.entity, state);
    }
}

void Physics::State::remove_character(std::uint32_t index) {
    const auto found = characters.find(index);
    world.removeCollisionObject(found->second.object.get());
    characters.erase(found);
}

}  // namespace lanthorn::physics
