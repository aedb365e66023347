// Animation and skinning in one run, on one core: 100 figures of 60 joints, all keyed and all moving, that
// share one mesh of 2 k vertices with 4 influences each. A copy of the same bytes takes turns with them, so
// that both see the same machine. The time is sampling and skinning together; counters:
//   sampling_ms, skinning_ms   Animator::animate, Deformation::update
//   transforms_ms              Transforms::update between them, beside the time
//   processor_ms               sampling and skinning in this process's processor time
//   vertices/s                 by sampling and skinning together
//   of_copy                    how long memcpy takes that reads and writes as many bytes in all, divided by
//                              how long sampling and skinning took
//   bench_deformation --benchmark_filter=walking --benchmark_repetitions=9
//   --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include <cstring>

#include "lanthorn/animation/animator.h"
#include "lanthorn/deformation/deformation.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"
#include "tests/bench/animation/keyed_clip.h"
#include "tests/bench/deformation/crowd.h"
#include "tests/support/clocks.h"

namespace deformation_bench {
namespace {

constexpr std::uint32_t kFigures = 100, kVertices = 2000, kJoints = 60, kInfluences = 4;

// Of a joint: two keys of translation, rotation and scale with their times read, a LocalTransform written. Of
// a vertex: place, normal, tangent and influences read, a VertexFrame written.
constexpr std::size_t kBytes =
    std::size_t{kFigures} * kJoints * (2 * (10 + 3) * 4 + sizeof(LocalTransform)) +
    std::size_t{kFigures} * kVertices * (40 + kInfluences * 6 + sizeof(VertexFrame));

// Wall and processor seconds, added up over stretches.
struct Stopwatch {
    double wall = 0, processor = 0;

    template <class Work>
    void time(const Work& work) {
        const double wall_from = support::wall_seconds(), processor_from = support::processor_seconds();
        work();
        processor += support::processor_seconds() - processor_from;
        wall += support::wall_seconds() - wall_from;
    }
};

SceneData figure() {
    SceneData scene;
    scene.nodes.resize(kJoints);
    for (std::uint32_t j = 1; j < kJoints; ++j) {
        scene.nodes[j].parent = (j - 1) / 2;
    }
    scene.animations.push_back(animation_bench::keyed_clip(kJoints, Interpolation::linear));
    return scene;
}

void walking(benchmark::State& state) {
    tbb::task_arena one(1);
    ecs::World world;
    std::mt19937 random(5);
    AssetStore& store = asset_store(world);
    store.add(Material());
    const MeshHandle mesh = store.add(figure_mesh(kVertices, kJoints, kInfluences, random));
    for (std::uint32_t f = 0; f < kFigures; ++f) {
        const std::vector<ecs::Entity> joints = spawn(world, figure());
        const ecs::Entity body = world.create(MeshInstances{{mesh}}, WorldTransform{});
        world.add(body, SkinInstance{joints, std::vector<mat4>(kJoints, mat4(1))});
    }
    double start = 0;
    for (const ecs::Entity e : world.query<ecs::With<AnimationSet>>().entities()) {
        AnimationPlayer player;
        player.layers.emplace_back().time = start += 0.013;
        world.add(e, std::move(player));
    }

    Animator animator;
    Transforms transforms;
    Deformation deformation;
    Stopwatch sampling, moving, skinning, copying;
    std::vector<char> from(kBytes / 2, 1), to(kBytes / 2);
    one.execute([&] {
        animator.animate(world, 0);
        transforms.update(world);
        deformation.update(world);
        for (auto _ : state) {
            const double before = sampling.wall + skinning.wall;
            sampling.time([&] { animator.animate(world, 1.0 / 60); });
            moving.time([&] { transforms.update(world); });
            skinning.time([&] { deformation.update(world); });
            state.SetIterationTime(sampling.wall + skinning.wall - before);
            copying.time([&] {
                std::memcpy(to.data(), from.data(), to.size());
                benchmark::DoNotOptimize(to.data());
                benchmark::ClobberMemory();
            });
        }
    });
    const auto frames = double(state.iterations());
    const double both = sampling.wall + skinning.wall;
    state.counters["sampling_ms"] = 1e3 * sampling.wall / frames;
    state.counters["skinning_ms"] = 1e3 * skinning.wall / frames;
    state.counters["transforms_ms"] = 1e3 * moving.wall / frames;
    state.counters["processor_ms"] = 1e3 * (sampling.processor + skinning.processor) / frames;
    state.counters["vertices/s"] = kFigures * kVertices * frames / both;
    state.counters["of_copy"] = copying.wall / both;
}
BENCHMARK(walking)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace deformation_bench
