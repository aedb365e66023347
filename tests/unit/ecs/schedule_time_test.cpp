// What systems see as changed when some of them move time on.
#include <gtest/gtest.h>

#include <stdexcept>

#include "lanthorn/ecs/schedule.h"
#include "tests/unit/ecs/components.h"

namespace lanthorn::ecs {
namespace schedule_time_test {

using namespace ecs_test;

// Like Transforms or Physics: keeps its own mark, and makes `marks` of them a run.
class Watcher {
  public:
    explicit Watcher(int marks) : marks_(marks) {}
    void look(World& world) {
        found = world.query<Changed<Position>>(since_).count();
        for (int i = 0; i < marks_; ++i) {
            since_ = world.mark();
        }
    }
    std::size_t found = 0;

  private:
    int marks_;
    Tick since_ = 0;
};

void move_all(Query<Write<Position>, Read<Velocity>> moving) {
    moving.each([](Position& p, const Velocity& v) { p.x += v.x; });
}

TEST(ScheduleTime, WhatIsWrittenAfterASystemThatMarksIsSeenByItNextTime) {
    for (const int marks : {1, 2, 3, 300}) {
        World world;
        world.create(Position{}, Velocity{1, 0, 0});
        world.create(Position{});
        Watcher watcher(marks);
        Schedule schedule;
        schedule.add("watch", [&](World& w) { watcher.look(w); });
        schedule.add("move", move_all);
        schedule.run(world);
        EXPECT_EQ(watcher.found, 2u) << marks;
        for (int i = 0; i < 3; ++i) {
            schedule.run(world);
            EXPECT_EQ(watcher.found, 1u) << marks << " marks, run " << i;
        }
    }
}

TEST(ScheduleTime, EditsAfterTheRunAreSeenInTheNext) {
    for (const int marks : {1, 2, 300}) {
        World world;
        const Entity e = world.create(Position{});
        Watcher watcher(marks);
        std::size_t seen = 0;
        Schedule schedule;
        schedule.add("watch", [&](World& w) { watcher.look(w); });
        schedule.add("see", [&](Query<Changed<Position>> q) { seen = q.count(); }).skip_if_empty(false);
        schedule.run(world);
        schedule.run(world);
        EXPECT_EQ(watcher.found, 0u) << marks;
        EXPECT_EQ(seen, 0u) << marks;
        world.get_mut<Position>(e).x = 1;
        schedule.run(world);
        EXPECT_EQ(watcher.found, 1u) << marks;
        EXPECT_EQ(seen, 1u) << marks;
    }
}

TEST(ScheduleTime, WhatASystemWritesBetweenItsMarksIsNewToTheOthersAndNotToItself) {
    World world;
    const Entity e = world.create(Position{});
    std::vector<std::size_t> own, later;
    Schedule schedule;
    schedule.add("write", [&, e](World& w, SystemTicks ticks) {
        own.push_back(w.query<Changed<Position>>(ticks.since).count());
        for (int i = 0; i < 100; ++i) {
            w.mark();
            w.get_mut<Position>(e).x += 1;
        }
    });
    schedule.add("look", [&](Query<Changed<Position>> q) { later.push_back(q.count()); })
        .skip_if_empty(false);
    for (int i = 0; i < 3; ++i) {
        schedule.run(world);
    }
    EXPECT_EQ(own, (std::vector<std::size_t>{1, 0, 0}));
    EXPECT_EQ(later, (std::vector<std::size_t>{1, 1, 1}));
}

TEST(ScheduleTime, NeverRunsBackwards) {
    World world;
    world.create(Position{}, Velocity{});
    Tick latest = 0;
    const auto note = [&](Tick now) {
        EXPECT_GE(now, latest);
        latest = now;
    };
    Schedule schedule;
    schedule.set_threads(1);
    schedule.add("first", [&](SystemTicks ticks, Query<Write<Velocity>>) { note(ticks.now); });
    schedule.add("alone", [&](World& w) {
        note(w.now());
        for (int i = 0; i < 50; ++i) {
            w.mark();
        }
        note(w.now());
    });
    schedule.add("between", [&](SystemTicks ticks, Query<Read<Velocity>>) { note(ticks.now); });
    schedule.add("alone again", [&](World& w) {
        note(w.now());
        w.mark();
        w.mark();
        note(w.now());
    });
    schedule.add("last", [&](SystemTicks ticks, Query<Read<Velocity>>) { note(ticks.now); });
    for (int i = 0; i < 3; ++i) {
        schedule.run(world);
        EXPECT_GT(world.now(), latest);
        note(world.now());
    }
}

TEST(ScheduleTime, RunsOnAfterASystemThrows) {
    World world;
    const Entity e = world.create(Position{});
    Watcher watcher(7);
    bool fail = false;
    Schedule schedule;
    schedule.add("watch", [&](World& w) {
        watcher.look(w);
        if (fail) {
            throw std::runtime_error("from a system");
        }
    });
    schedule.run(world);
    fail = true;
    EXPECT_THROW(schedule.run(world), std::runtime_error);
    fail = false;
    world.get_mut<Position>(e).x = 1;
    schedule.run(world);
    EXPECT_EQ(watcher.found, 1u);
}

}  // namespace schedule_time_test
}  // namespace lanthorn::ecs
