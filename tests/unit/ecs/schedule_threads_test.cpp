// Which thread runs what, and at the same time as what.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <atomic>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "lanthorn/ecs/schedule.h"
#include "tests/unit/ecs/components.h"
#include "tests/unit/ecs/expect_error.h"

namespace lanthorn::ecs {
namespace {

using namespace ecs_test;

std::string numbered(const char* name, int number) {
    std::string text = name;
    text += std::to_string(number);
    return text;
}

// More threads than this machine may have.
class ScheduleThreads : public testing::Test {
    tbb::global_control control_{tbb::global_control::max_allowed_parallelism, 6};
};

TEST_F(ScheduleThreads, AWatcherSeesTheWorldAfterEachSystemInOrder) {
    World world;
    world.insert_resource(Position{0});
    Schedule schedule;
    for (int i = 0; i < 4; ++i) {
        auto config =
            schedule.add(numbered("s", i), [i](ResMut<Position> p) { p->x = static_cast<float>(i); });
        if (i > 0) {
            config.after(numbered("s", i - 1));
        }
    }
    schedule.add("makes", [](Commands& commands) { commands.create(Position{7}); }).after("s3");
    std::vector<std::string> seen;
    schedule.watch([&](const std::string& system, bool commands, const World& w) {
        seen.push_back(system + (commands ? "+" : "") +
                       std::to_string(static_cast<int>(w.resource<Position>().x)) + std::to_string(w.size()));
    });
    schedule.run(world);
    EXPECT_EQ(seen, (std::vector<std::string>{"s000", "s110", "s220", "s330", "makes30", "makes+31"}));
    schedule.watch({});
    schedule.run(world);
    EXPECT_EQ(seen.size(), 6u);
}

TEST_F(ScheduleThreads, MainThreadSystemsRunOnTheCallersThread) {
    for (const int threads : {0, 1, 2, 4}) {
        World world;
        Schedule schedule;
        schedule.set_threads(threads);
        const std::thread::id caller = std::this_thread::get_id();
        std::atomic<int> elsewhere = 0, ran = 0;
        for (int i = 0; i < 30; ++i) {
            auto config = schedule.add(numbered("s", i), [&, main = i % 3 == 0] {
                ++ran;
                elsewhere += main && std::this_thread::get_id() != caller;
            });
            if (i % 3 == 0) {
                config.on_main_thread();
            }
            if (i >= 5) {
                config.after(numbered("s", i - 5));
            }
            if (i % 11 == 10) {
                schedule.add_sync_point(numbered("sync", i));
            }
        }
        for (int run = 0; run < 200; ++run) {
            schedule.run(world);
        }
        EXPECT_EQ(elsewhere, 0) << threads;
        EXPECT_EQ(ran, 200 * 30) << threads;
    }
}

TEST_F(ScheduleThreads, AMainThreadSystemOverlapsAWorkers) {
    for (const int threads : {0, 2, 4}) {
        World world;
        std::latch both(2);
        std::thread::id main, worker;
        Schedule schedule;
        schedule.set_threads(threads);
        // Neither ends before the other began.
        schedule.add("work", [&] {
            worker = std::this_thread::get_id();
            both.arrive_and_wait();
        });
        schedule
            .add("draw",
                 [&] {
                     main = std::this_thread::get_id();
                     both.arrive_and_wait();
                 })
            .on_main_thread();
        schedule.run(world);
        EXPECT_EQ(main, std::this_thread::get_id());
        EXPECT_NE(worker, main);
    }
}

TEST_F(ScheduleThreads, AMainThreadSystemThatWaitedOverlapsAWorkersToo) {
    World world;
    std::latch both(2);
    Schedule schedule;
    schedule.set_threads(3);
    schedule.add("prepare", [] {}).on_main_thread();
    schedule.add("draw", [&] { both.arrive_and_wait(); }).after("prepare").on_main_thread();
    schedule.add("work", [&] { both.arrive_and_wait(); });
    schedule.run(world);
    EXPECT_TRUE(both.try_wait());
}

TEST_F(ScheduleThreads, MainThreadSystemsKeepTheOrderOfTheScheduleAmongThemselves) {
    World world;
    Schedule schedule;
    schedule.set_threads(4);
    std::vector<int> log;
    for (int i = 0; i < 8; ++i) {
        schedule.add(numbered("load", i), [] {});
        auto draw = schedule.add(numbered("draw", i), [&log, i] { log.push_back(i); }).on_main_thread();
        if (i % 2 == 0) {
            draw.after(numbered("load", i));
        }
    }
    const auto names = schedule.order();
    std::vector<int> expected;
    for (const std::string& name : names) {
        if (name.starts_with("draw")) {
            expected.push_back(std::stoi(name.substr(4)));
        }
    }
    for (int run = 0; run < 300; ++run) {
        log.clear();
        schedule.run(world);
        ASSERT_EQ(log, expected) << run;
    }
}

// What is free to start on the main thread is listed while others, already running, make more of it ready.
TEST_F(ScheduleThreads, MainThreadSystemsAreNotLostWhileOthersMakeThemReady) {
    World world;
    Schedule schedule;
    schedule.set_threads(4);
    int drawn = 0;
    constexpr int kSystems = 48;
    for (int i = 0; i < kSystems; ++i) {
        schedule.add(numbered("load", i), [] {});
        auto draw = schedule.add(numbered("draw", i), [&drawn] { ++drawn; }).on_main_thread();
        if (i % 2 == 0) {
            draw.after(numbered("load", i));
        }
    }
    for (int run = 0; run < 2000; ++run) {
        drawn = 0;
        schedule.run(world);
        ASSERT_EQ(drawn, kSystems) << run;
    }
}

TEST_F(ScheduleThreads, OrdersHoldBetweenMainThreadAndOtherSystems) {
    struct Chain {
        std::atomic<int> done = 0;
    };
    for (const int threads : {1, 2, 4}) {
        World world;
        Schedule schedule;
        schedule.set_threads(threads);
        std::vector<Chain> chains(6);
        std::atomic<int> wrong = 0;
        for (int step = 0; step < 6; ++step) {
            for (int c = 0; c < 6; ++c) {
                const std::string name = numbered(numbered("chain", c).append(" step").c_str(), step);
                auto config = schedule.add(name, [&, c, step] {
                    wrong += chains[static_cast<std::size_t>(c)].done.exchange(step + 1) != step;
                });
                if (step > 0) {
                    config.after(numbered(numbered("chain", c).append(" step").c_str(), step - 1));
                }
                if ((c + step) % 2 == 0) {
                    config.on_main_thread();
                }
            }
        }
        for (int run = 0; run < 200; ++run) {
            for (Chain& chain : chains) {
                chain.done = 0;
            }
            schedule.run(world);
        }
        EXPECT_EQ(wrong, 0) << threads;
    }
}

TEST_F(ScheduleThreads, ExceptionsOfMainThreadSystemsComeOut) {
    for (const int threads : {1, 4}) {
        World world;
        bool fail = true;
        int after = 0;
        Schedule schedule;
        schedule.set_threads(threads);
        schedule.add("first", [] {});
        schedule
            .add("draw",
                 [&] {
                     if (fail) {
                         throw std::runtime_error("no context");
                     }
                 })
            .after("first")
            .on_main_thread();
        schedule.add("show", [&] { ++after; }).after("draw").on_main_thread();
        EXPECT_THROW(schedule.run(world), std::runtime_error);
        EXPECT_EQ(after, 0);
        fail = false;
        schedule.run(world);
        EXPECT_EQ(after, 1);
    }
}

TEST_F(ScheduleThreads, TheGraphShowsWhatRunsOnTheMainThread) {
    Schedule schedule;
    schedule.add("draw", [](Query<Read<Position>>) {}).on_main_thread();
    schedule.add("move", [](Query<Write<Position>>) {});
    const std::string dot = schedule.to_dot();
    EXPECT_NE(dot.find("2 draw\\non the main thread\\nreads component"), std::string::npos) << dot;
    EXPECT_EQ(dot.find("1 move\\non the main thread"), std::string::npos) << dot;
}

// Others' chance to take what should not be theirs.
void yield_to_others() {
    for (int i = 0; i < 1000; ++i) {
        std::this_thread::yield();
    }
}

// Runs a parallel_each of two chunks, in a system that shares its segment and in one that runs alone.
template <class Fn>
void run_two_chunks(int threads, const Fn& fn) {
    World world;
    std::vector<Entity> firsts;  // of the chunks
    world.create_many(4000, Position{});
    world.query<Read<Position>>().each_chunk(
        [&](std::span<const Entity> entities, std::span<const Position>) { firsts.push_back(entities[0]); });
    ASSERT_EQ(firsts.size(), 2u);
    Schedule schedule;
    schedule.set_threads(threads);
    const auto visit = [&](std::size_t system) {
        return [&, system](Entity e, Position&) {
            if (e == firsts[0] || e == firsts[1]) {
                fn(system);
            }
        };
    };
    schedule.add("shared", [&](Query<Write<Position>> q) { q.parallel_each(visit(0)); });
    schedule.add("other", [] {});
    schedule.add("alone", [&](World& w) { w.query<Write<Position>>().parallel_each(visit(1)); });
    schedule.run(world);
}

TEST_F(ScheduleThreads, OneThreadMeansTheCallersForParallelEachToo) {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    run_two_chunks(1, [&](std::size_t) {
        {
            const std::lock_guard lock(mutex);
            seen.insert(std::this_thread::get_id());
        }
        yield_to_others();
    });
    EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

TEST_F(ScheduleThreads, ChunksOfParallelEachOverlap) {
    std::array<std::latch, 2> both{std::latch(2), std::latch(2)};
    run_two_chunks(4, [&](std::size_t system) { both[system].arrive_and_wait(); });
    EXPECT_TRUE(both[0].try_wait() && both[1].try_wait());
}

TEST_F(ScheduleThreads, NoOtherSystemRunsOnTheStackOfOneThatWaits) {
    static thread_local int depth = 0;
    World world;
    world.create_many(20'000, Position{}, Velocity{1, 0, 0});
    Schedule schedule;
    schedule.set_threads(4);
    std::atomic<int> nested = 0;
    for (int i = 0; i < 24; ++i) {
        schedule.add(numbered("s", i), [&](Query<Read<Position>, Read<Velocity>> q) {
            nested += depth != 0;
            ++depth;
            std::atomic<int> count = 0;
            q.parallel_each([&](const Position&, const Velocity&) {
                if (++count % 5000 == 0) {
                    yield_to_others();
                }
            });
            --depth;
            EXPECT_EQ(count, 20'000);
        });
    }
    for (int run = 0; run < 3; ++run) {
        schedule.run(world);
    }
    EXPECT_EQ(nested, 0);
}

TEST_F(ScheduleThreads, ParallelEachRefusesCommandsAndEvents) {
    struct Note {
        int number;
    };
    for (const int threads : {1, 2, 4}) {
        for (const std::size_t entities : {1u, 20'000u}) {
            World world;
            world.create_many(entities, Position{});
            Schedule schedule;
            schedule.set_threads(threads);
            int which = 0;
            schedule.add("write", [&](Query<Read<Position>> q, Commands& commands, EventWriter<Note> notes) {
                q.parallel_each([&](Entity e, const Position&) {
                    if (which == 0) {
                        commands.destroy(e);
                    } else if (which == 1) {
                        commands.create(Position{});
                    } else {
                        notes.send({1});
                    }
                });
            });
            EXPECT_ECS_ERROR(schedule.run(world), "cannot give commands inside parallel_each");
            which = 1;
            EXPECT_ECS_ERROR(schedule.run(world), "cannot give commands inside parallel_each");
            which = 2;
            EXPECT_ECS_ERROR(schedule.run(world), "cannot send events inside parallel_each");
            EXPECT_EQ(world.size(), entities);
            Commands commands(world);
            commands.create(Position{});
            commands.apply();
            EXPECT_EQ(world.size(), entities + 1);
        }
    }
}

}  // namespace
}  // namespace lanthorn::ecs
