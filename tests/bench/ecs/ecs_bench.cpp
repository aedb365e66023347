// Speed of the ECS.   bench_ecs --benchmark_filter=...
// Iterations report `ratio`: their time over that of a plain loop over the same arrays, taken in turn with
// it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <string>
#include <vector>

#include "lanthorn/ecs/schedule.h"
#include "tests/bench/ecs/contender.h"

namespace lanthorn::ecs {
namespace {

constexpr std::size_t kMillion = 1'000'000;

// Half of the entities have all three components: 2.5 on average.
void fill(World& world, std::size_t count) {
    for (std::size_t i = 0; i < count / 2; ++i) {
        world.create(Position{}, Velocity{});
        world.create(Position{}, Velocity{}, Heat{});
    }
}

void create(benchmark::State& state) {
    for (auto _ : state) {
        auto world = std::make_unique<World>();
        fill(*world, kMillion);
        state.PauseTiming();
        world.reset();
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kMillion));
}
BENCHMARK(create)->Unit(benchmark::kMillisecond);

void create_many(benchmark::State& state) {
    for (auto _ : state) {
        auto world = std::make_unique<World>();
        benchmark::DoNotOptimize(world->create_many(kMillion, Position{}, Velocity{}));
        state.PauseTiming();
        world.reset();
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kMillion));
}
BENCHMARK(create_many)->Unit(benchmark::kMillisecond);

void destroy(benchmark::State& state) {
    for (auto _ : state) {
        state.PauseTiming();
        auto world = std::make_unique<World>();
        fill(*world, kMillion);
        const std::vector<Entity> all = world->query<Read<Position>>().entities();
        state.ResumeTiming();
        for (const Entity e : all) {
            world->destroy(e);
        }
        state.PauseTiming();
        world.reset();
        state.ResumeTiming();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kMillion));
}
BENCHMARK(destroy)->Unit(benchmark::kMillisecond);

double seconds(const auto& fn) {
    const auto start = std::chrono::steady_clock::now();
    fn();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Times `ecs` and, in turn with it, `plain`.
void against_plain(benchmark::State& state, const auto& ecs, const auto& plain) {
    double ours = 0, theirs = 0;
    for (auto _ : state) {
        theirs += seconds(plain);
        const double t = seconds(ecs);
        ours += t;
        state.SetIterationTime(t);
    }
    state.counters["ratio"] = ours / theirs;
    state.counters["plain_ms"] = theirs / static_cast<double>(state.iterations()) * 1e3;
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kMillion));
}

void iterate_one(benchmark::State& state) {
    World world;
    world.create_many(kMillion, Position{});
    std::vector<Position> positions(kMillion);
    against_plain(
        state,
        [&] {
            world.query<Write<Position>>().each([](Position& p) { p.x += 1; });
            benchmark::ClobberMemory();
        },
        [&] {
            for (Position& p : positions) {
                p.x += 1;
            }
            benchmark::ClobberMemory();
        });
}
BENCHMARK(iterate_one)->UseManualTime()->Unit(benchmark::kMillisecond);

void step(Position& p, const Velocity& v, Heat& h) {
    constexpr float dt = 1.0f / 60;
    p.x += v.x * dt;
    p.y += v.y * dt;
    p.z += v.z * dt;
    h.value *= 0.999f;
}

void iterate_three(benchmark::State& state) {
    World world;
    world.create_many(kMillion, Position{}, Velocity{}, Heat{});
    std::vector<Position> positions(kMillion);
    std::vector<Velocity> velocities(kMillion);
    std::vector<Heat> heats(kMillion);
    against_plain(
        state,
        [&] {
            world.query<Write<Position>, Read<Velocity>, Write<Heat>>().each(step);
            benchmark::ClobberMemory();
        },
        [&] {
            for (std::size_t i = 0; i < kMillion; ++i) {
                step(positions[i], velocities[i], heats[i]);
            }
            benchmark::ClobberMemory();
        });
}
BENCHMARK(iterate_three)->UseManualTime()->Unit(benchmark::kMillisecond);

void iterate_three_chunks(benchmark::State& state) {
    World world;
    world.create_many(kMillion, Position{}, Velocity{}, Heat{});
    std::vector<Position> positions(kMillion);
    std::vector<Velocity> velocities(kMillion);
    std::vector<Heat> heats(kMillion);
    against_plain(
        state,
        [&] {
            world.query<Write<Position>, Read<Velocity>, Write<Heat>>().each_chunk(
                [](std::span<Position> p, std::span<const Velocity> v, std::span<Heat> h) {
                    for (std::size_t i = 0; i < p.size(); ++i) {
                        step(p[i], v[i], h[i]);
                    }
                });
            benchmark::ClobberMemory();
        },
        [&] {
            for (std::size_t i = 0; i < kMillion; ++i) {
                step(positions[i], velocities[i], heats[i]);
            }
            benchmark::ClobberMemory();
        });
}
BENCHMARK(iterate_three_chunks)->UseManualTime()->Unit(benchmark::kMillisecond);

// One in a hundred rows changed: what a system that follows changes pays.
void iterate_changed(benchmark::State& state) {
    World world;
    const std::vector<Entity> all = world.create_many(kMillion, Position{}, Velocity{});
    const Tick mark = world.mark();
    for (std::size_t i = 0; i < kMillion; i += 100) {
        world.get_mut<Position>(all[i]).x = 1;
    }
    for (auto _ : state) {
        float sum = 0;
        world.query<Read<Position>, Changed<Position>>(mark).each([&](const Position& p) { sum += p.x; });
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kMillion));
}
BENCHMARK(iterate_changed)->Unit(benchmark::kMillisecond);

void random_get(benchmark::State& state) {
    World world;
    fill(world, kMillion);
    std::vector<Entity> order = world.query<Read<Position>>().entities();
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    for (auto _ : state) {
        float sum = 0;
        for (const Entity e : order) {
            sum += world.get<Velocity>(e).x;
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kMillion));
}
BENCHMARK(random_get)->Unit(benchmark::kMillisecond);

void add_remove_churn(benchmark::State& state) {
    World world;
    const std::vector<Entity> all = world.create_many(kMillion / 10, Position{}, Velocity{});
    for (auto _ : state) {
        for (const Entity e : all) {
            world.add(e, Heat{});
        }
        for (const Entity e : all) {
            world.remove<Heat>(e);
        }
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(2 * all.size()));
}
BENCHMARK(add_remove_churn)->Unit(benchmark::kMillisecond);

// 64 systems over an entity each: what a run costs besides the systems' work. Argument: threads (0: all).
void schedule_of_64(benchmark::State& state) {
    World world;
    world.create(Position{}, Velocity{});
    world.insert_resource(Heat{});
    Schedule schedule;
    schedule.set_threads(static_cast<int>(state.range(0)));
    std::string last;
    for (int i = 0; i < 64; ++i) {
        const std::string name = "system " + std::to_string(i);
        switch (i % 4) {
            case 0: {
                auto config = schedule.add(name, [](Query<Write<Position>, Read<Velocity>> q) {
                    q.each([](Position& p, const Velocity& v) { p.x += v.x; });
                });
                if (!last.empty()) {
                    config.after(last);
                }
                last = name;
                break;
            }
            case 1:
                schedule.add(name, [](Query<Read<Velocity>> q, Res<Heat> heat) {
                    benchmark::DoNotOptimize(q.count());
                    benchmark::DoNotOptimize(heat->value);
                });
                break;
            case 2:
                schedule.add(name, [](Query<Read<Position>>, Commands&) {});
                break;
            case 3:
                schedule.add(name, [](Query<Read<Heat>>) {});
                break;  // finds nothing
        }
    }
    schedule.build();
    for (auto _ : state) {
        schedule.run(world);
    }
}
BENCHMARK(schedule_of_64)->Arg(1)->Arg(0)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace lanthorn::ecs
