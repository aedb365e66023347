// Speed of snapshots and state hashes: 10 000 entities with six components, as a game's scene has them.
#include <benchmark/benchmark.h>

#include <string>

#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"

namespace lanthorn::ecs {
namespace {

constexpr std::size_t kEntities = 10'000;

struct Place {
    dvec3 translation{0};
    glm::quat rotation{1, 0, 0, 0};
    vec3 scale{1};
};
struct Matrix {
    dmat4 value{1};
};
struct Named {
    std::string value;
};
struct Fixed {
    Entity to;
};
struct Lamp {
    vec3 colour{1};
    float intensity = 1;
    bool lit = true;
};
struct Weights {
    std::vector<float> values;
};

void declare(Registry& registry) {
    registry.component<Place>("place", "", field("translation", &Place::translation),
                              field("rotation", &Place::rotation), field("scale", &Place::scale));
    registry.component<Matrix>("matrix", "", field("value", &Matrix::value)).transient();
    registry.component<Named>("named", "", field("value", &Named::value));
    registry.component<Fixed>("fixed", "", field("to", &Fixed::to));
    registry.component<Lamp>("lamp", "", field("colour", &Lamp::colour), field("intensity", &Lamp::intensity),
                             field("lit", &Lamp::lit));
    registry.component<Weights>("weights", "", field("values", &Weights::values));
}

// All have a place, a matrix and a name; half a parent, a tenth a lamp or weights.
void fill(World& world) {
    for (std::size_t i = 0; i < kEntities; ++i) {
        const Entity e =
            world.create(Place{}, Matrix{}, Named{"a node of the scene, no. " + std::to_string(i)});
        if (i % 2 == 1) {
            world.add(e, Fixed{e});
        }
        if (i % 10 == 0) {
            world.add(e, Lamp{});
        }
        if (i % 10 == 5) {
            world.add(e, Weights{{0, 0.5f, 1, 0}});
        }
    }
}

struct Bench {
    Bench() {
        declare(registry);
        fill(world);
    }
    Registry registry;
    World world;
};

void snapshot_save(benchmark::State& state) {
    const Bench bench;
    for (auto _ : state) {
        benchmark::DoNotOptimize(Snapshot::save(bench.world, bench.registry).size());
    }
}

// A tenth of the entities moved since.
void snapshot_restore(benchmark::State& state) {
    Bench bench;
    const Snapshot snapshot = Snapshot::save(bench.world, bench.registry);
    for (auto _ : state) {
        state.PauseTiming();
        for (std::uint32_t i = 0; i < kEntities; i += 10) {
            bench.world.get_mut<Place>({i, 1}).translation.x += 1;
        }
        bench.world.mark();
        state.ResumeTiming();
        snapshot.restore(bench.world);
    }
}

void snapshot_to_bytes(benchmark::State& state) {
    const Bench bench;
    const Snapshot snapshot = Snapshot::save(bench.world, bench.registry);
    for (auto _ : state) {
        benchmark::DoNotOptimize(snapshot.to_bytes().size());
    }
}

void snapshot_from_bytes(benchmark::State& state) {
    const Bench bench;
    const std::string bytes = Snapshot::save(bench.world, bench.registry).to_bytes();
    for (auto _ : state) {
        benchmark::DoNotOptimize(Snapshot::from_bytes(bytes, bench.registry, "bytes").size());
    }
}

void hash_of_state(benchmark::State& state) {
    const Bench bench;
    for (auto _ : state) {
        benchmark::DoNotOptimize(state_hashes(bench.registry, bench.world));
    }
}

BENCHMARK(snapshot_save)->Unit(benchmark::kMillisecond);
BENCHMARK(snapshot_restore)->Unit(benchmark::kMillisecond);
BENCHMARK(snapshot_to_bytes)->Unit(benchmark::kMillisecond);
BENCHMARK(snapshot_from_bytes)->Unit(benchmark::kMillisecond);
BENCHMARK(hash_of_state)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lanthorn::ecs
