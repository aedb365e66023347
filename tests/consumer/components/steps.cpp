// A world, a system and a schedule, without anything of scenes or pictures.
#include <cstdio>

#include "lanthorn/ecs/schedule.h"

struct Position {
    double metres = 0;
};

struct Speed {
    double metres_a_second = 0;
};

void move(lanthorn::ecs::Query<lanthorn::ecs::Write<Position>, lanthorn::ecs::Read<Speed>> things) {
    things.each([](Position& at, const Speed& speed) { at.metres += speed.metres_a_second / 60; });
}

int main() {
    lanthorn::ecs::World world;
    const lanthorn::ecs::Entity thing = world.create(Position{1}, Speed{2});
    lanthorn::ecs::Schedule schedule("steps");
    schedule.add("move", move);
    for (int step = 0; step < 60; ++step) {
        schedule.run(world);
    }
    const double at = world.get<Position>(thing).metres;
    std::printf("after a second at %.6f m\n", at);
    return at > 2.999999 && at < 3.000001 ? 0 : 1;
}
