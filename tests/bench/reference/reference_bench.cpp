// The path tracer's ray rate against Embree's own: the rays of a sample of each pixel are noted, path after
// path as a path tracer without batches would ask for them, then traced again in a bare loop with the same
// calls (rtcIntersect1 and rtcOccluded1, one ray each) over the same acceleration structure. One thread each
// and by the processor's clock, so that other work on the machine counts for little. The loop reads its rays
// from memory one behind the other and waits for no answer, which no renderer can do: it is an upper bound.
// And what a second thread brings: by the wall's clock, and how many rays a second of the processor's remain,
// which does not count the time that other work takes away. Medians of five turns in which each has its own,
// so that all see the same machine.
//   bench_reference [SECONDS [SCENE]]   a measurement's length; a file of assets/, else the usual ones
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "tests/bench/reference/bare_rate.h"
#include "tests/support/clocks.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

using namespace lanthorn;
using namespace lanthorn::reference;

namespace {

constexpr ivec2 kSize(256);

FrameScene load(ecs::World& world, const std::string& name) {
    const auto entities = spawn(world, import_gltf(support::repository_file("assets/" + name)));
    for (const ecs::Entity e : entities) {
        if (world.has<CameraComponent>(e)) {
            return Extractor().extract(world, e);
        }
    }
    return Extractor().extract(world);
}

struct SampleRate {
    double wall = 0;       // samples a pixel and second
    double processor = 0;  // and second of the processor, all threads together
};

SampleRate sample_rate(const FrameScene& frame, PathSettings settings, int threads, double seconds) {
    settings.threads = threads;
    settings.spp = 1'000'000;
    settings.time_limit = static_cast<float>(seconds);
    PathTracer tracer(frame, kSize, settings, {.indirect = true});
    const double start = support::processor_seconds();
    const PathProgress done = tracer.render({});
    return {done.spp / done.seconds, done.spp / (support::processor_seconds() - start)};
}

void measure(const std::string& name, Transport transport, double seconds) {
    ecs::World world;
    const FrameScene frame = load(world, name);
    PathSettings settings;
    settings.transport = transport;
    settings.spp = 1;
    settings.threads = 1;
    PathTracer tracer(frame, kSize, settings, {.indirect = true});
    RayLog log = tracer.log_rays();
    const double rays_a_sample = static_cast<double>(log.rays.size());
    constexpr int kTurns = 5;
    std::array<double, kTurns> bare, one, share, faster, kept;
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
        bare[turn] = bench::bare_rate(log, seconds);
        const SampleRate single = sample_rate(frame, settings, 1, seconds);
        const SampleRate both = sample_rate(frame, settings, 2, seconds);
        one[turn] = rays_a_sample * single.processor;
        share[turn] = one[turn] / bare[turn];
        faster[turn] = both.wall / single.wall;
        kept[turn] = both.processor / single.processor;
    }
    fmt::print(
        "{:<18} {:<8} {:4.1f} rays a pixel; M rays/s: Embree {:6.2f}, path {:6.2f} ({:.0f} %); 2 threads "
        "{:.2f} x "
        "({:.0f} % a processor second)\n",
        name, transport_name(transport), rays_a_sample / (kSize.x * kSize.y), support::median(bare) * 1e-6,
        support::median(one) * 1e-6, 100 * support::median(share), support::median(faster),
        100 * support::median(kept));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const double seconds = argc > 1 ? std::atof(argv[1]) : 2;
        if (!(seconds > 0)) {
            fmt::print(stderr, "bench_reference: '{}' where seconds were expected, more than 0\n", argv[1]);
            return 2;
        }
        if (argc > 2) {
            measure(argv[2], Transport::diffuse, seconds);
            measure(argv[2], Transport::full, seconds);
            return 0;
        }
        for (const char* scene : {"cornell.glb", "two-rooms.glb", "clutter.glb", "furnace-sphere.glb"}) {
            measure(scene, Transport::diffuse, seconds);
        }
        measure("cornell.glb", Transport::full, seconds);
        measure("clutter.glb", Transport::full, seconds);
    } catch (const Error& error) {
        fmt::print(stderr, "bench_reference: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
