// The photon tracer's ray rate against Embree's own, as bench_reference has it for paths: the rays of 100 000
// walks are noted and traced again in a bare loop with rtcIntersect1 over the same structure, one thread each
// and by the processor's clock. And what a second thread brings. Medians of five turns in which each has its
// own.
//   bench_photons [SECONDS [SCENE...]]   a measurement's length; files of assets/, else the usual ones
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "gi_module/shared/photons/photon_tracer.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "tests/bench/reference/bare_rate.h"
#include "tests/support/clocks.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

using namespace lanthorn;
using namespace lanthorn::gi;

namespace {

constexpr std::uint64_t kWalks = 100'000;

struct Rate {
    double wall = 0, processor = 0;  // rays a second
};

Rate photon_rate(const PhotonTracer& tracer, int threads, double seconds) {
    reference::TileWorkers workers(threads);
    std::uint64_t rays = 0, first = 0;
    const double start = support::processor_seconds(), wall = support::wall_seconds();
    do {
        rays += tracer.trace(first, kWalks, workers, [](std::size_t, std::span<const Photon>) {}).rays;
        first += kWalks;
    } while (support::wall_seconds() - wall < seconds);
    return {static_cast<double>(rays) / (support::wall_seconds() - wall),
            static_cast<double>(rays) / (support::processor_seconds() - start)};
}

void measure(const std::string& name, PhotonScattering scattering, double seconds) {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file("assets/" + name)));
    const FrameScene frame = Extractor().extract(world);
    const reference::MaterialTable materials(*frame.assets);
    reference::TraceScene scene(frame, materials, reference::Structure::moving);
    const PhotonSources sources(scene, materials);
    const PhotonTracer tracer(scene, materials, sources, {.bounces = 2, .seed = 1, .scattering = scattering});
    reference::TileWorkers alone(1);
    reference::RayLog log;
    scene.log_to(&log);
    tracer.trace(0, kWalks, alone);
    scene.log_to(nullptr);
    std::array<double, 5> bare{}, one{}, share{}, faster{};
    for (std::size_t turn = 0; turn < 5; ++turn) {
        bare[turn] = bench::bare_rate(log, seconds);
        const Rate single = photon_rate(tracer, 1, seconds);
        one[turn] = single.processor;
        share[turn] = single.processor / bare[turn];
        faster[turn] = photon_rate(tracer, 2, seconds).wall / single.wall;
    }
    fmt::print(
        "{:<20} {:<5} {:4.2f} rays a walk; M rays/s: Embree {:6.2f}, photons {:6.2f} ({:.0f} %); 2 threads "
        "{:.2f} x\n",
        name, scattering == PhotonScattering::even ? "even" : "full",
        static_cast<double>(log.rays.size()) / kWalks, support::median(bare) * 1e-6,
        support::median(one) * 1e-6, 100 * support::median(share), support::median(faster));
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const double seconds = argc > 1 ? std::atof(argv[1]) : 1;
        if (!(seconds > 0)) {
            fmt::print(stderr, "bench_photons: '{}' where seconds were expected, more than 0\n", argv[1]);
            return 2;
        }
        std::vector<std::string> scenes(argv + std::min(argc, 2), argv + argc);
        if (scenes.empty()) {
            scenes = {"cornell.glb", "two-rooms.glb", "clutter.glb"};
        }
        for (const std::string& scene : scenes) {
            measure(scene, PhotonScattering::even, seconds);
            measure(scene, PhotonScattering::full, seconds);
        }
    } catch (const Error& error) {
        fmt::print(stderr, "bench_photons: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
