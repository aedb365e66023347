// Hello, Lanthorn: the smallest program that uses the engine. Copy it.
#include <cstdio>

#include "engine/ecs/query.h"
#include "engine/ecs/world.h"

using namespace lanthorn;

// Components are plain types; anything movable will do.
struct Position {
    float x = 0;
};
struct Velocity {
    float x = 0;  // metres a second
};

int main() {
    // A world holds entities; an entity is a handle with components.
    ecs::World world;
    const ecs::Entity moth = world.create(Position{0}, Velocity{2});
    const ecs::Entity lamp = world.create(Position{5});  // stands still: no velocity

    // A query visits every entity that has the components it names. Write says what may be altered.
    constexpr float kStep = 1.0f / 60;
    for (int step = 0; step < 60; ++step) {
        world.query<ecs::Write<Position>, ecs::Read<Velocity>>().each(
            [](Position& position, const Velocity& velocity) { position.x += velocity.x * kStep; });
    }

    const float moth_at = world.get<Position>(moth).x;
    const float lamp_at = world.get<Position>(lamp).x;
    std::printf("after a second the moth is at %.2f m, the lamp at %.2f m\n", moth_at, lamp_at);
    return moth_at > 1.99f && moth_at < 2.01f && lamp_at == 5 ? 0 : 1;
}
