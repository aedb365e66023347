// A world, a system and a schedule, without anything of scenes or pictures.
#include <cstdio>

#include "lanthorn/ecs/schedule.h"

namespace ecs = lanthorn::ecs;

struct Position {
    double metres = 0;
};

struct Speed {
    double metres_a_second = 0;
};

void move(ecs::Query<ecs::Write<Position>, ecs::Read<Speed>> things) {
    things.each([](Position& at, const Speed& speed) { at.metres += speed.metres_a_second / 60; });
}

int main() {
    ecs::World world;
    const ecs::Entity thing = world.create(Position{1}, Speed{2});
    ecs::Schedule schedule("steps");
    schedule.add("move", move);
    for (int step = 0; step < 60; ++step) {
        schedule.run(world);
    }
    const double at = world.get<Position>(thing).metres;
    std::printf("after a second at %.6f m\n", at);
    return at > 2.999999 && at < 3.000001 ? 0 : 1;
}
