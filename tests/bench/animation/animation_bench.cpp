// Sampling and blending on one core. 100 figures of 60 joints whose translation, rotation and scale are keyed
// 30 times a second for 4 s; each step is 1/60 s.
//   bench_animation --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>

#include "engine/animation/key_sampler.h"
#include "lanthorn/animation/animator.h"
#include "lanthorn/scene/spawn.h"
#include "tests/bench/animation/keyed_clip.h"

namespace {

using namespace lanthorn;

using animation_bench::keyed_clip;

constexpr std::uint32_t kFigures = 100, kJoints = 60;

SceneData figure(std::uint32_t clips, Interpolation interpolation) {
    SceneData scene;
    scene.nodes.resize(kJoints);
    for (std::uint32_t j = 1; j < kJoints; ++j) {
        scene.nodes[j].parent = j - 1;
    }
    for (std::uint32_t c = 0; c < clips; ++c) {
        scene.animations.push_back(keyed_clip(kJoints, interpolation));
    }
    return scene;
}

// range(0): layers; range(1): Interpolation.
void Figures(benchmark::State& state) {
    const auto layers = static_cast<std::uint32_t>(state.range(0));
    ecs::World world;
    for (std::uint32_t i = 0; i < kFigures; ++i) {
        spawn(world, figure(layers, static_cast<Interpolation>(state.range(1))));
    }
    std::uint32_t started = 0;
    for (const ecs::Entity e : world.query<ecs::With<AnimationSet>>().entities()) {
        AnimationPlayer player;
        for (std::uint32_t l = 0; l < layers; ++l) {
            AnimationLayer& layer = player.layers.emplace_back();
            layer.clip = l;
            layer.time = 0.013 * ++started;
        }
        world.add(e, std::move(player));
    }
    Animator animator;
    animator.animate(world, 0);
    for (auto _ : state) {
        animator.animate(world, 1.0 / 60);
    }
    state.counters["joints/s"] =
        benchmark::Counter(kFigures * kJoints, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(Figures)
    ->ArgNames({"layers", "interpolation"})
    ->Args({1, static_cast<int>(Interpolation::linear)})
    ->Args({1, static_cast<int>(Interpolation::cubic_spline)})
    ->Args({2, static_cast<int>(Interpolation::linear)})
    ->Unit(benchmark::kMillisecond);

// One channel at random times, so that the hint never helps: the cost grows with log keys.
void RandomAccess(benchmark::State& state) {
    AnimationChannel c;
    c.width = 3;
    for (std::int64_t k = 0; k < state.range(0); ++k) {
        c.times.push_back(static_cast<float>(k));
        c.values.insert(c.values.end(), {1, 2, 3});
    }
    std::uint32_t hint = 0;
    std::uint32_t random = 1;
    double value[3];
    for (auto _ : state) {
        random = random * 1664525 + 1013904223;
        sample(c, random * (static_cast<double>(state.range(0) - 1) / 4294967296.0), hint, value);
        benchmark::DoNotOptimize(value[0]);
    }
}
BENCHMARK(RandomAccess)->RangeMultiplier(16)->Range(16, 65536);

}  // namespace
