// Ten thousand entities that each show a mesh: world transforms, then the FrameScene with its world-space
// bounds and what changed, each timed on its own; moving the entities is not timed.
//   bench_scene --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>

#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"
#include "tests/support/clocks.h"

namespace {

using namespace lanthorn;

constexpr std::uint32_t kEntities = 10'000;
constexpr std::uint32_t kTree = 15;  // a binary tree four deep

enum class Shape { flat, trees };

// Wall time and this process's processor time, milliseconds; other programs disturb the second less.
struct Clocks {
    double wall = support::wall_ms(), processor = support::processor_ms();

    double wall_ms() const { return support::wall_ms() - wall; }
    double processor_ms() const { return support::processor_ms() - processor; }
};

struct Crowd {
    ecs::World world;
    std::vector<ecs::Entity> entities;
    Transforms transforms;
    Extractor extractor;

    explicit Crowd(Shape shape) {
        Mesh box;
        for (int corner = 0; corner < 8; ++corner) {
            Vertex v;
            v.position = vec3(corner & 1, corner >> 1 & 1, corner >> 2);
            box.vertices.push_back(v);
            box.bounds.add(v.position);
        }
        box.indices = {0, 1, 2};
        AssetStore& store = asset_store(world);
        store.add(Material());
        const MeshHandle mesh = store.add(std::move(box));
        for (std::uint32_t i = 0; i < kEntities; ++i) {
            LocalTransform local;
            local.value.translation = {double(i % 100), double(i / 100), 0};
            const ecs::Entity e = world.create(local, WorldTransform{}, MeshInstances{{mesh}});
            if (shape == Shape::trees && i % kTree > 0) {
                const std::uint32_t parent = i - i % kTree + (i % kTree - 1) / 2;
                world.add(e, Parent{entities[parent]});
            }
            entities.push_back(e);
        }
        refresh();
    }

    void move(std::uint32_t every, int frame) {
        for (std::uint32_t i = 0; i < kEntities; i += every) {
            Transform& local = world.get_mut<LocalTransform>(entities[i]).value;
            local.translation.z = 0.01 * double(frame % 100);
            local.rotation = glm::angleAxis(0.1f * float(frame % 60), vec3(0, 1, 0));
        }
    }
    void refresh() {
        transforms.update(world);
        benchmark::DoNotOptimize(extractor.extract(world));
    }
};

// range(0): Shape; range(1): one in so many moves (of trees: a root in 15 rows, or any node).
void moving(benchmark::State& state) {
    Crowd crowd(static_cast<Shape>(state.range(0)));
    const auto every = static_cast<std::uint32_t>(state.range(1));
    int frame = 0;
    double transforms = 0, bounds = 0, processor = 0, computed = 0;
    for (auto _ : state) {
        crowd.move(every, ++frame);
        const Clocks whole;
        computed += double(crowd.transforms.update(crowd.world));
        const double first = whole.wall_ms();
        FrameScene scene = crowd.extractor.extract(crowd.world);
        benchmark::DoNotOptimize(scene);
        const double all = whole.wall_ms();
        processor += whole.processor_ms();
        state.SetIterationTime(1e-3 * all);
        transforms += first;
        bounds += all - first;
    }
    const auto frames = double(state.iterations());
    state.counters["transforms_ms"] = transforms / frames;
    state.counters["bounds_ms"] = bounds / frames;
    state.counters["processor_ms"] = processor / frames;
    state.counters["computed"] = computed / frames;
}
BENCHMARK(moving)
    ->ArgNames({"trees", "every"})
    ->Args({0, 1})
    ->Args({0, 100})
    ->Args({0, kEntities})
    ->Args({1, 1})
    ->Args({1, 100})
    ->Args({1, kEntities})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
