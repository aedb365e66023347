// What splatting photons costs, beside a straightforward gather of the same photons with a k-d tree: each
// pixel asks the tree for all photons within its bandwidth and sums those of its surface. The same photons,
// bandwidths, kernel and areas, so the same error but for rounding, which is printed. And the tables of
// Lavignotte and Paulin 2003. By the processor's clock, all threads together.
//   bench_splat gather [WALKS [SIDE [SCENE]]]   splats against the gather at SIDE x SIDE pixels
//   bench_splat table1 SCENE...                 times of a coarse solution, 100 000 walks
//   bench_splat table2 SCENE...                 1e5, 1e6 and 1e7 walks, fixed and adaptive bandwidths
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <nanoflann.hpp>
#include <string>
#include <vector>

#include "gi_module/techniques/splat/splat_technique.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/transforms.h"
#include "tests/support/clocks.h"
#include "tests/support/repository.h"

using namespace lanthorn;
using namespace lanthorn::gi;

namespace {

// A scene as its camera sees it, and all that splats are made of.
struct Stage {
    ecs::World world;
    FrameScene frame;
    render::FrameRenderer renderer;
    gpu::PassTimer timer{false, false};
    reference::TileWorkers workers{0};
    PhotonScene scene;
    SplatSurfaces surfaces;
    PictureSurfaces picture;
    PhotonCollection photons;
    PhotonSplats splats;
    double tracing = 0;  // seconds

    Stage(const std::string& name, ivec2 size) {
        spawn(world, import_gltf(support::repository_file("assets/" + name)));
        Transforms().update(world);
        const ecs::Entity camera = find_by_name(world, "camera");
        frame = world.alive(camera) ? Extractor().extract(world, camera) : Extractor().extract(world);
        scene.follow(frame, PhotonScattering::even);
        surfaces.follow(frame, workers);
        see(size);
    }
    void see(ivec2 size) {
        renderer.begin(frame, size, timer);
        renderer.draw_light_maps(frame, timer);
        renderer.draw_gbuffer(frame, timer);
        picture.find(renderer.inputs(frame, timer), scene, surfaces, workers);
    }
    void trace(std::uint64_t walks, std::size_t memory) {
        photons.clear();
        photons.store().limit(memory - PhotonCollection::kTracing);
        const double start = support::processor_seconds();
        if (!photons.grow(scene, surfaces, {.bounces = 2, .seed = 1}, walks, workers)) {
            throw InputError(photons.store().error());
        }
        tracing = support::processor_seconds() - start;
    }
    // Seconds; with everything that an altered view needs.
    double splat(const SplatSettings& settings, const gpu::Texture** image = nullptr) {
        const double start = support::processor_seconds();
        const gpu::Texture* irradiance =
            splats.draw(picture, surfaces, photons, photons.powers(scene.sources()), settings, workers);
        glFinish();
        if (image != nullptr) {
            *image = irradiance;
        }
        return support::processor_seconds() - start;
    }
};

// All photons in a row, for nanoflann.
struct Cloud {
    std::vector<PhotonRecord> records;
    std::vector<vec3> powers;

    std::size_t kdtree_get_point_count() const { return records.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return records[i].position[static_cast<glm::length_t>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

// How far splats and gather may differ: rounding. A ceiling, which only goes down.
constexpr double kMostDifference = 1e-6;

// False: above the ceiling.
bool gather(std::uint64_t walks, int side, const std::string& name) {
    Stage stage(name, ivec2(side));
    stage.trace(walks, std::size_t{1} << 30);
    SplatSettings settings;
    settings.adaptive = SplatAdaptive::none;
    settings.caustic_bandwidth = settings.bandwidth;
    stage.splat(settings);  // programs are compiled
    const gpu::Texture* image = nullptr;
    const double splatted = stage.splat(settings, &image);
    const std::vector<float> got = image->read_floats(4);

    double start = support::processor_seconds();
    const std::vector<vec3> group_powers = stage.photons.powers(stage.scene.sources());
    Cloud cloud;
    stage.photons.store().each([&](const RecordRun& run) {
        if (!run.caustic) {
            cloud.records.insert(cloud.records.end(), run.records.begin(), run.records.end());
            for (const PhotonBlock& block : run.blocks) {
                cloud.powers.insert(cloud.powers.end(), block.count, group_powers[block.group]);
            }
        }
    });
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3>;
    const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
    const double built = support::processor_seconds() - start;
    start = support::processor_seconds();
    const std::vector<float> h = bandwidths(stage.surfaces, stage.photons.photons(false), settings.bandwidth);
    const std::vector<float> areas =
        inverse_kernel_areas(stage.picture, stage.surfaces, h, settings.kernel, true, {}, stage.workers);
    const auto pixels = stage.picture.pixels();
    std::vector<vec3> gathered(pixels.size(), vec3(0));
    tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t i) {
        if (pixels[i].side == kNoSide || !(h[pixels[i].side] > 0)) {
            return;
        }
        static thread_local std::vector<std::pair<std::uint32_t, float>> found;
        found.clear();
        const float square = h[pixels[i].side] * h[pixels[i].side];
        nanoflann::RadiusResultSet<float, std::uint32_t> result(square, found);
        const vec3& p = pixels[i].position;
        const float query[3] = {p.x, p.y, p.z};
        tree.findNeighbors(result, query, nanoflann::SearchParams(32, 0, false));
        vec3 sum(0);
        for (const auto& [index, distance] : found) {
            const PhotonRecord& r = cloud.records[index];
            if (r.side() == pixels[i].side) {
                sum += cloud.powers[index] * vec3(r.copies(0), r.copies(1), r.copies(2));
            }
        }
        gathered[i] = sum * areas[i];
    });
    const double looked_up = support::processor_seconds() - start;
    double squares = 0, mean = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            squares +=
                std::pow(static_cast<double>(got[4 * i + c] - gathered[i][static_cast<glm::length_t>(c)]), 2);
            mean += static_cast<double>(gathered[i][static_cast<glm::length_t>(c)]);
        }
    }
    const double n = 3 * static_cast<double>(pixels.size());
    fmt::print(
        "{} {} x {}: {} photons of {} walks, traced in {:.2f} s; splats {:.2f} s; gather {:.2f} s and {:.2f} "
        "s to build the "
        "tree: {:.2f} x the splats' time; they differ by {:.1e} of the mean (CPU seconds)\n",
        name, side, side, cloud.records.size(), walks, stage.tracing, splatted, looked_up, built,
        (looked_up + built) / splatted, std::sqrt(squares / n) / (mean / n));
    return std::sqrt(squares / n) / (mean / n) <= kMostDifference;
}

void table1(const std::vector<std::string>& scenes) {
    fmt::print(
        "| scene | triangles | PT | NS | PS1 512x512 | PS2 900x900 | IR |\n|---|---|---|---|---|---|---|\n");
    for (const std::string& name : scenes) {
        Stage stage(name, ivec2(512));
        stage.trace(100'000, std::size_t{64} << 20);
        SplatSettings settings;
        settings.adaptive = SplatAdaptive::none;
        stage.splat(settings);
        settings.boundaries = false;
        const double first = stage.splat(settings);
        settings.boundaries = true;
        const double corrected = stage.splat(settings);
        settings.boundaries = false;
        stage.see(ivec2(900));
        const double second = stage.splat(settings);
        fmt::print("| {} | {} | {:.2f} s | {} | {:.2f} s | {:.2f} s | {:.2f} s |\n", name,
                   stage.scene.surfaces().triangles().size(), stage.tracing,
                   stage.photons.all(false) + stage.photons.all(true), first, second,
                   std::max(corrected - first, 0.0));
    }
}

void table2_of(const std::string& name) {
    for (const std::uint64_t walks : {100'000ull, 1'000'000ull, 10'000'000ull}) {
        Stage stage(name, ivec2(512));
        stage.trace(walks, std::size_t{64} << 20);
        SplatSettings settings;
        settings.adaptive = SplatAdaptive::none;
        stage.splat(settings);
        const double fixed = stage.splat(settings);
        settings.adaptive = SplatAdaptive::all;
        const double adaptive = stage.splat(settings);
        fmt::print("| {} | {:.0e} | {} | {:.2f} s | {:.2f} s | {:.2f} s | {:.1f} | {:.1f} |\n", name,
                   static_cast<double>(walks), stage.photons.all(false) + stage.photons.all(true),
                   stage.tracing, fixed, adaptive,
                   static_cast<double>(stage.photons.store().most_memory()) / (1 << 20),
                   static_cast<double>(stage.photons.store().on_disk()) / (1 << 20));
    }
}

void table2(const std::vector<std::string>& scenes) {
    fmt::print(
        "| scene | walks | photons | tracing | fixed | adaptive | memory, MiB | on disk, MiB "
        "|\n|---|---|---|---|---|---|---|---|\n");
    std::ranges::for_each(scenes, table2_of);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::vector<std::string> words(argv + 1, argv + argc);
        const auto context = gpu::create_headless_context();
        context->make_current();
        if (words.size() >= 2 && words[0] == "table1") {
            table1({words.begin() + 1, words.end()});
        } else if (words.size() >= 2 && words[0] == "table2") {
            table2({words.begin() + 1, words.end()});
        } else if (!words.empty() && words[0] == "gather") {
            const long long walks = words.size() > 1 ? std::atoll(words[1].c_str()) : 1'000'000;
            const int side = words.size() > 2 ? std::atoi(words[2].c_str()) : 512;
            if (walks <= 0 || side <= 0) {
                fmt::print(stderr, "bench_splat: WALKS and SIDE are numbers, more than 0\n");
                return 2;
            }
            return gather(static_cast<std::uint64_t>(walks), side,
                          words.size() > 3 ? words[3] : "cornell.glb")
                       ? 0
                       : 1;
        } else {
            fmt::print(stderr, "bench_splat: found no 'gather', 'table1 SCENE...' or 'table2 SCENE...'\n");
            return 2;
        }
    } catch (const Error& error) {
        fmt::print(stderr, "bench_splat: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
