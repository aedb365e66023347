// A scene of a thousand nodes that is in the world already, once more: by its handle, and from its data,
// which have to be recognised. Destroying it between is not timed but in `destroying`.
//   bench_scene --benchmark_filter=spawning --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/spawn.h"

namespace {

using namespace lanthorn;

constexpr std::uint32_t kNodes = 1000;

// Ten rooms of a hundred things, half of which are fixed to another and half of which show a mesh.
SceneData thousand_nodes() {
    SceneData scene;
    scene.source = "thousand.glb";
    scene.materials.resize(10);
    for (std::uint32_t m = 0; m < 10; ++m) {
        Mesh& box = scene.meshes.emplace_back();
        box.material = m;
        for (int corner = 0; corner < 8; ++corner) {
            Vertex& v = box.vertices.emplace_back();
            v.position = vec3(corner & 1, corner >> 1 & 1, corner >> 2);
            box.bounds.add(v.position);
        }
        box.indices = {0, 1, 2, 1, 3, 2};
    }
    for (std::uint32_t i = 0; i < kNodes; ++i) {
        NodeData& node = scene.nodes.emplace_back();
        node.name = "thing " + std::to_string(i);
        node.local.translation = {double(i % 100), double(i / 100), 0};
        if (i % 2 == 1) {
            node.parent = i - 1;
            node.meshes = {i % 10};
        }
    }
    return scene;
}

struct Stage {
    ecs::World world;
    SceneData data = thousand_nodes();
    SceneHandle handle = asset_store(world).add(data);
    AssetHold<SceneAsset> kept = asset_store(world).hold(handle);
};

template <class Act>
void timed(benchmark::State& state, const Act& act) {
    const auto start = std::chrono::steady_clock::now();
    act();
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

void spawning_by_handle(benchmark::State& state) {
    Stage stage;
    for (auto _ : state) {
        timed(state, [&] { spawn(stage.world, stage.handle); });
        stage.world.clear();
    }
}
void spawning_data(benchmark::State& state) {
    Stage stage;
    for (auto _ : state) {
        timed(state, [&] { spawn(stage.world, stage.data); });
        stage.world.clear();
    }
}
void recognising_data(benchmark::State& state) {
    Stage stage;
    for (auto _ : state) {
        timed(state, [&] { benchmark::DoNotOptimize(asset_store(stage.world).add(stage.data)); });
    }
}
void destroying(benchmark::State& state) {
    Stage stage;
    for (auto _ : state) {
        spawn(stage.world, stage.handle);
        timed(state, [&] { stage.world.clear(); });
    }
}
BENCHMARK(spawning_by_handle)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(spawning_data)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(recognising_data)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(destroying)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
