// Skinning and morphing against a copy of the same bytes, on one core. Counters: vertices/s, and `of_copy`:
// how long memcpy takes that reads and writes as many bytes in all, divided by how long this took.
//   bench_deformation --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cstring>

#include "engine/deformation/morph.h"
#include "engine/deformation/skinning.h"
#include "lanthorn/deformation/deformation.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"
#include "tests/bench/deformation/crowd.h"

namespace deformation_bench {
namespace {

constexpr std::uint32_t kFigures = 100, kVertices = 2000, kJoints = 60;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Alternates `work` with a copy that moves `bytes` (read and written), so that both see the same machine.
template <class Work>
void against_copy(benchmark::State& state, std::size_t bytes, double vertices, const Work& work) {
    std::vector<char> from(bytes / 2, 1), to(bytes / 2);
    double working = 0, copying = 0;
    for (auto _ : state) {
        auto start = std::chrono::steady_clock::now();
        work();
        const double taken = seconds_since(start);
        state.SetIterationTime(taken);
        working += taken;
        start = std::chrono::steady_clock::now();
        std::memcpy(to.data(), from.data(), to.size());
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
        copying += seconds_since(start);
    }
    state.counters["vertices/s"] = vertices * double(state.iterations()) / working;
    state.counters["of_copy"] = copying / working;
}

// The kernel alone: `kFigures` figures of one mesh, each its own vertices out.
void skin(benchmark::State& state) {
    const auto influences = std::uint32_t(state.range(0));
    std::mt19937 random(1);
    const deform::BindPose pose = deform::pack(figure_mesh(kVertices, kJoints, influences, random));
    std::vector<deform::JointMatrix> joints;
    for (std::uint32_t j = 0; j < kJoints; ++j) {
        joints.push_back(deform::joint_matrix(joint_pose(j, 7), mat4(1), dvec3(0)));
    }
    std::vector<std::vector<VertexFrame>> to(kFigures, std::vector<VertexFrame>(kVertices));
    // Read: vertex and influences; written: VertexFrame.
    const std::size_t bytes_per_vertex = 40 + influences * 6 + 40;
    against_copy(state, bytes_per_vertex * kVertices * kFigures, kVertices * kFigures, [&] {
        for (auto& figure : to) {
            deform::BoundsLanes bounds;
            deform::skin_groups(pose, joints, 0, pose.groups, figure.data(), bounds);
            benchmark::DoNotOptimize(bounds);
        }
    });
}
BENCHMARK(skin)->Arg(1)->Arg(2)->Arg(4)->Arg(8)->UseManualTime()->Unit(benchmark::kMillisecond);

struct Crowd {
    ecs::World world;
    Deformation deformation;
    std::vector<std::vector<ecs::Entity>> joints;

    explicit Crowd(Mesh mesh, std::uint32_t morph_weights = 0) {
        AssetStore& store = asset_store(world);
        store.add(Material());
        const MeshHandle shown = store.add(std::move(mesh));
        for (std::uint32_t f = 0; f < kFigures; ++f) {
            joints.push_back(world.create_many(kJoints, WorldTransform{}));
            const ecs::Entity e = world.create(MeshInstances{{shown}}, WorldTransform{});
            world.add(e, SkinInstance{joints.back(), std::vector<mat4>(kJoints, mat4(1))});
            if (morph_weights > 0) {
                world.add(e, MorphWeights{std::vector<float>(morph_weights)});
            }
        }
    }
    void pose(int frame) {
        for (const auto& figure : joints) {
            for (std::uint32_t j = 0; j < kJoints; ++j) {
                world.get_mut<WorldTransform>(figure[j]).matrix = joint_pose(j, frame);
            }
        }
    }
};

// The whole system with all joints moving.
void crowd(benchmark::State& state) {
    tbb::task_arena one(1);
    std::mt19937 random(2);
    Crowd crowd(figure_mesh(kVertices, kJoints, 4, random));
    int frame = 0;
    for (auto _ : state) {
        crowd.pose(++frame);
        const auto start = std::chrono::steady_clock::now();
        one.execute([&] { crowd.deformation.update(crowd.world); });
        state.SetIterationTime(seconds_since(start));
    }
    state.counters["vertices/s"] =
        benchmark::Counter(kVertices * kFigures, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(crowd)->UseManualTime()->Unit(benchmark::kMillisecond);

// Nothing moves.
void crowd_at_rest(benchmark::State& state) {
    tbb::task_arena one(1);
    std::mt19937 random(3);
    Crowd crowd(figure_mesh(kVertices, kJoints, 4, random));
    crowd.pose(1);
    for (auto _ : state) {
        one.execute([&] { crowd.deformation.update(crowd.world); });
    }
}
BENCHMARK(crowd_at_rest)->Unit(benchmark::kMillisecond);

// Four targets on, of as many as the argument says: the same time for 4 and for 100.
void morph(benchmark::State& state) {
    std::mt19937 random(4);
    Mesh mesh = figure_mesh(kVertices, kJoints, 4, random);
    for (int i = 0; i < state.range(0); ++i) {
        mesh.morphs.push_back(morph_of(mesh, 10, random));
    }
    Crowd crowd(std::move(mesh), std::uint32_t(state.range(0)));
    tbb::task_arena one(1);
    int frame = 0;
    crowd.pose(1);
    const auto figures = crowd.world.query<ecs::With<MorphWeights>>().entities();
    for (auto _ : state) {
        ++frame;
        for (const ecs::Entity e : figures) {
            auto& weights = crowd.world.get_mut<MorphWeights>(e).weights;
            for (std::size_t i = 0; i < 4; ++i) {
                weights[i * weights.size() / 4] = 0.1f * float(1 + (frame + int(i)) % 9);
            }
        }
        const auto start = std::chrono::steady_clock::now();
        one.execute([&] { crowd.deformation.update(crowd.world); });
        state.SetIterationTime(seconds_since(start));
    }
}
BENCHMARK(morph)->Arg(4)->Arg(100)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace deformation_bench
