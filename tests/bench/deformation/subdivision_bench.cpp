// Refining 10 k control points to level 2 against OpenSubdiv's own evaluator called bare on the same
// stencils, in turn, on one core. Counters: `of_limit`: OpenSubdiv's time for positions and both tangents,
// which a normal needs, divided by ours for whole vertices (position, normal, tangent, bounds);
// `of_position`: likewise its time for positions alone.
#include <benchmark/benchmark.h>
#include <opensubdiv/osd/cpuEvaluator.h>

#include <chrono>

#include "engine/deformation/subdivision_surface.h"

namespace deformation_bench {
namespace {

using namespace lanthorn;

Mesh wavy_grid(std::uint32_t size, std::uint32_t level) {
    Mesh mesh;
    mesh.cage = SubdivisionCage{SubdivisionScheme::catmull_clark, level, {}, {}};
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            Vertex v;
            v.position = {float(x), float(y), std::sin(0.3f * float(x)) * std::cos(0.2f * float(y))};
            mesh.vertices.push_back(v);
            if (x == 0 || y == 0) {
                continue;
            }
            const std::uint32_t i = y * size + x;
            mesh.cage->face_sizes.push_back(4);
            mesh.indices.insert(mesh.indices.end(), {i - size - 1, i - size, i, i - size - 1, i, i - 1});
        }
    }
    return mesh;
}

// The stencils as OpenSubdiv keeps them.
struct Table {
    std::vector<int> sizes, offsets, indices;
    std::vector<float> position, du, dv;

    explicit Table(const deform::LimitStencils& from) {
        for (const deform::LimitVertex& v : from.vertices) {
            offsets.push_back(int(indices.size()));
            sizes.push_back(int(v.end - v.first));
            for (std::uint32_t i = v.first; i < v.end; ++i) {
                indices.push_back(int(from.entries[i].control));
                position.push_back(from.entries[i].position);
                du.push_back(from.entries[i].du);
                dv.push_back(from.entries[i].dv);
            }
        }
    }
};

class Clock {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void subdivide(benchmark::State& state) {
    using OpenSubdiv::Osd::BufferDescriptor;
    using OpenSubdiv::Osd::CpuEvaluator;
    const Mesh mesh = wavy_grid(100, std::uint32_t(state.range(0)));
    deform::SubdivisionSurface surface(mesh);
    const deform::LimitStencils& stencils = surface.at(surface.finest()).stencils;
    const auto count = std::uint32_t(stencils.vertices.size());
    const Table table(stencils);
    std::vector<deform::Lanes> controls;
    std::vector<float> packed;
    for (const std::uint32_t v : surface.cage().control_vertices) {
        const vec3 p = mesh.vertices[v].position;
        controls.push_back(deform::Lanes{p.x, p.y, p.z, 0});
        packed.insert(packed.end(), {p.x, p.y, p.z});
    }
    std::vector<VertexFrame> ours(count);
    std::vector<float> position(count * 3), du(count * 3), dv(count * 3);
    const BufferDescriptor three(0, 3, 3);
    double own = 0, limit = 0, positions = 0;
    for (auto _ : state) {
        Clock clock;
        deform::BoundsLanes bounds;
        deform::evaluate(stencils, controls, false, 0, count, ours.data(), bounds);
        benchmark::DoNotOptimize(ours.data());
        const double taken = clock.lap();
        state.SetIterationTime(taken);
        own += taken;
        CpuEvaluator::EvalStencils(packed.data(), three, position.data(), three, du.data(), three, dv.data(),
                                   three, table.sizes.data(), table.offsets.data(), table.indices.data(),
                                   table.position.data(), table.du.data(), table.dv.data(), 0, int(count));
        limit += clock.lap();
        CpuEvaluator::EvalStencils(packed.data(), three, position.data(), three, table.sizes.data(),
                                   table.offsets.data(), table.indices.data(), table.position.data(), 0,
                                   int(count));
        positions += clock.lap();
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3 p(position[i * 3], position[i * 3 + 1], position[i * 3 + 2]);
        if (!(glm::length(p - ours[i].position) < 1e-3f)) {
            state.SkipWithError("the two disagree");
        }
    }
    state.counters["vertices"] = count;
    state.counters["entries"] = double(stencils.entries.size());
    state.counters["of_limit"] = limit / own;
    state.counters["of_position"] = positions / own;
}
BENCHMARK(subdivide)->Arg(1)->Arg(2)->UseManualTime()->Unit(benchmark::kMillisecond);

// What the first frame of a mesh pays.
void build(benchmark::State& state) {
    const Mesh mesh = wavy_grid(100, std::uint32_t(state.range(0)));
    for (auto _ : state) {
        deform::SubdivisionSurface surface(mesh);
        benchmark::DoNotOptimize(surface.at(surface.finest()));
    }
}
BENCHMARK(build)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace deformation_bench
