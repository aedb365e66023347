// The ways of splatting that give the same picture, in turns: processor time where that draws, else time on
// the GPU, by pass.
//   bench_splat_ways SCENE [PHOTONS] [WIDTH] [HEIGHT] [ROUNDS]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <list>
#include <map>
#include <string>
#include <vector>

#include "gi_module/techniques/emc/emc_technique.h"
#include "gi_module/techniques/emc/splat/splatting.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

using namespace lanthorn;

namespace {

using gi::SplatBinning;
using gi::SplatKernel;

struct Way {
    Way(SplatBinning binning, SplatKernel kernel)
        : name(fmt::format("{}, {}", binning == SplatBinning::by_tile ? "by tile" : "by photon",
                           kernel == SplatKernel::batches ? "batches" : "pixels")),
          splatting({.binning = binning}, kernel) {}

    std::string name;
    gi::Splatting splatting;
    std::map<std::string, std::vector<double>> ms;
};

int run(const std::string& scene, int photons, ivec2 size, int rounds) {
    const auto context = gpu::create_headless_context();
    const bool software = context->info().software;
    App app;
    add_scene_plugins(app);
    app.add<RenderPlugin>(false).add<gi::GiPlugin>();
    ecs::World& world = app.world();
    for (const ecs::Entity e : spawn(world, import_gltf(support::repository_file(scene)))) {
        if (world.has<CameraComponent>(e)) {
            app.view().camera = e;
        }
    }
    app.view().size = size;
    gi::GiSettings& settings = world.resource_mut<gi::GiSettings>();
    settings.edit<gi::EmcSettings>().final_stage = gi::EmcFinal::splat;
    settings.photons = photons;
    app.show();
    const auto& technique =
        static_cast<const gi::EmcTechnique&>(*world.resource<gi::ActiveTechnique>().technique);

    std::list<Way> ways;
    for (const SplatBinning binning : {SplatBinning::by_tile, SplatBinning::by_photon}) {
        for (const SplatKernel kernel : {SplatKernel::batches, SplatKernel::pixels}) {
            ways.emplace_back(binning, kernel);
        }
    }
    const gpu::Buffer bad_values(sizeof(std::uint32_t));
    gpu::PassTimer timer(true, software);
    for (int round = -1; round < rounds; ++round) {  // programs are compiled in the first
        for (Way& way : ways) {
            way.splatting.irradiance(
                world.resource<Renderer>().frame->inputs(world.resource<FrameScene>(), timer),
                technique.maps(), technique.photons().arrived(), world.resource<gi::GiSettings>(), true,
                bad_values);
            for (const auto& span : timer.end_frame()) {
                if (round >= 0) {
                    way.ms[span.name].push_back(software ? span.cpu_ms : span.ms);
                }
            }
        }
    }
    fmt::print("{}; {} {}x{}, {} photons; medians of {} rounds\n", context->info().renderer, scene, size.x,
               size.y, photons, rounds);
    for (const Way& way : ways) {
        fmt::print("  {:<20}", way.name);
        for (const auto& [pass, ms] : way.ms) {
            fmt::print(" {} {:8.2f} ms", pass, support::median(ms));
        }
        fmt::print(" ({} entries)\n", way.splatting.statistics().entries);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    const auto number = [&](int i, int usual) { return argc > i ? std::max(1, std::atoi(argv[i])) : usual; };
    try {
        return run(argc > 1 ? argv[1] : "assets/cornell.glb", number(2, 20'000),
                   {number(3, 512), number(4, 512)}, number(5, 9));
    } catch (const Error& error) {
        fmt::print(stderr, "bench_splat_ways: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
