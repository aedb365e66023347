// The path tracer's ray rate against Embree's own: the rays that it traced are noted, then traced again in a
// bare loop over the same acceleration structure, one thread each and by the processor's clock, so that other
// work on the machine counts for little. And what a second thread brings, by the wall's.
//   bench_reference [SECONDS [SCENE]]   a measurement's length; a file of assets/, else the usual ones
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "engine/assets/gltf_import.h"
#include "engine/core/error.h"
#include "engine/scene/extract.h"
#include "engine/scene/spawn.h"
#include "gi_module/reference/path_tracer.h"
#include "gi_module/reference/ray_log.h"

using namespace lanthorn;
using namespace lanthorn::reference;

namespace {

constexpr ivec2 kSize(256);

// Of the whole process.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

FrameScene load(ecs::World& world, const std::string& name) {
    const auto entities = spawn(world, import_gltf(LANTHORN_SOURCE_DIR "/assets/" + name));
    for (const ecs::Entity e : entities) {
        if (world.has<CameraComponent>(e)) {
            return Extractor().extract(world, e);
        }
    }
    return Extractor().extract(world);
}

// Rays a second of a bare loop over what was logged, in the order in which it was traced.
double bare_rate(const RayLog& log, double seconds) {
    std::uint64_t rays = 0;
    const double start = processor_seconds();
    do {
        for (const LoggedRay& logged : log.rays) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            if (logged.any_hit) {
                RTCRay ray = logged.ray;
                rtcOccluded1(log.scene, &context, &ray);
            } else {
                RTCRayHit query;
                query.ray = logged.ray;
                query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                rtcIntersect1(log.scene, &context, &query);
            }
        }
        rays += log.rays.size();
    } while (processor_seconds() - start < seconds);
    return static_cast<double>(rays) / (processor_seconds() - start);
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
    const double start = processor_seconds();
    const PathProgress done = tracer.render({});
    return {done.spp / done.seconds, done.spp / (processor_seconds() - start)};
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
    // In turns, so that both see the same machine; the best of each.
    double bare = 0, one = 0, one_by_wall = 0, two = 0;
    for (int turn = 0; turn < 3; ++turn) {
        bare = std::max(bare, bare_rate(log, seconds));
        const SampleRate single = sample_rate(frame, settings, 1, seconds);
        one = std::max(one, rays_a_sample * single.processor);
        one_by_wall = std::max(one_by_wall, rays_a_sample * single.wall);
        two = std::max(two, rays_a_sample * sample_rate(frame, settings, 2, seconds).wall);
    }
    fmt::print(
        "{:<16} {:<8} {:5.1f} rays a pixel; M rays/s: Embree {:6.2f}, path {:6.2f} ({:.0f} %), 2 threads "
        "{:6.2f} "
        "({:.2f} x)\n",
        name, transport_name(transport), rays_a_sample / (kSize.x * kSize.y), bare * 1e-6, one * 1e-6,
        100 * one / bare, two * 1e-6, two / one_by_wall);
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
