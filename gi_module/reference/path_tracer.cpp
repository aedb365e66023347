#include "lanthorn/reference/path_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "gi_module/reference/checkpoint.h"
#include "gi_module/reference/film.h"
#include "gi_module/reference/integrator.h"
#include "gi_module/reference/ray_log.h"
#include "gi_module/reference/scene_hash.h"
#include "gi_module/reference/tile_workers.h"

namespace lanthorn::reference {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kRun = 256;     // pixels that a thread takes at once
constexpr double kPassSeconds = 0.2;  // about how long a pass may take, so that cancelling is felt at once
constexpr int kMostPerPass = 256;     // samples
constexpr int kFirstNoiseCheck = 16;  // samples: with fewer the estimate means little
constexpr std::uint32_t kLensDimension = 0xffffffu;

// Noise is looked at after these numbers of samples and no others, so that the image does not depend on how
// long passes take: each about a fifth more than the last.
int next_noise_check(int spp) {
    int check = kFirstNoiseCheck;
    while (check <= spp) {
        check += std::max(check / 10 * 2, 2);
    }
    return check;
}

}  // namespace

struct PathTracer::State {
    State(const FrameScene& frame, ivec2 image_size, const PathSettings& path_settings, PathParts path_parts)
        : settings(path_settings),
          parts{path_parts.indirect, path_parts.direct, path_parts.radiance},
          size(image_size),
          scene_number(reference::scene_hash(frame)),
          sample_number(sample_hash(frame, image_size, path_settings)),
          materials(*frame.assets),
          scene(frame, materials),
          emitters(scene, materials, path_settings.transport == Transport::full),
          lights(frame),
          sky(frame),
          camera(frame.camera, image_size),
          integrator(scene, materials, emitters, lights, sky, path_settings),
          workers(path_settings.threads) {
        for (std::size_t i = 0; i < films.size(); ++i) {
            if (wanted(i)) {
                films[i] = Film(size);
            }
        }
        first.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        for_each_run([&](std::size_t begin, std::size_t pixels) {
            for (std::size_t pixel = begin; pixel < begin + pixels; ++pixel) {
                first[pixel] = integrator.first_surface(centre_ray(pixel));
            }
        });
    }

    bool wanted(std::size_t film) const {
        return film == 0 ? parts.indirect : film == 1 ? parts.direct : parts.radiance;
    }
    CameraRay camera_ray(std::size_t pixel, const vec2& within) const {
        const auto across = static_cast<std::size_t>(size.x);
        return camera.ray(static_cast<float>(pixel % across) + within.x,
                          static_cast<float>(pixel / across) + within.y);
    }
    CameraRay centre_ray(std::size_t pixel) const { return camera_ray(pixel, vec2(0.5f)); }

    // All pixels in runs of neighbours, each run on one thread: visit(first, number of pixels).
    template <class Visit>
    void for_each_run(const Visit& visit) {
        workers.run((first.size() + kRun - 1) / kRun,
                    [&](std::size_t run) { visit(run * kRun, std::min(kRun, first.size() - run * kRun)); });
    }

    // The next `count` samples of some neighbouring pixels, to add(pixel, number, sample). Of all pixels
    // before the next number, kLanes at a time.
    template <class Add>
    void sample(std::size_t begin, std::size_t pixels, int count, const Add& add) const {
        std::array<SampleStart, kLanes> starts;
        std::array<std::optional<FirstSurface>, kLanes> seen;
        std::array<PathSample, kLanes> results;
        std::size_t pixel = begin;
        auto number = static_cast<std::uint32_t>(spp);
        const std::uint32_t end = number + static_cast<std::uint32_t>(count);
        while (number < end) {
            const std::size_t first_pixel = pixel;
            const std::uint32_t first_number = number;
            const auto next = [&] {
                if (++pixel == begin + pixels) {
                    pixel = begin;
                    ++number;
                }
            };
            std::size_t lanes = 0;
            for (; lanes < kLanes && number < end; ++lanes, next()) {
                starts[lanes] = start(pixel, number, seen[lanes]);
            }
            integrator.sample(std::span(starts).first(lanes), parts, results);
            pixel = first_pixel;
            number = first_number;
            for (std::size_t lane = 0; lane < lanes; ++lane, next()) {
                add(pixel, number, results[lane]);
            }
        }
    }

    // `seen` holds what the start refers to.
    SampleStart start(std::size_t pixel, std::uint32_t number, std::optional<FirstSurface>& seen) const {
        const RandomNumbers random(settings.seed, static_cast<std::uint32_t>(pixel), number);
        const auto address = [](const std::optional<FirstSurface>& s) { return s ? &*s : nullptr; };
        if (!settings.antialias) {
            // The ray itself matters to what lies before the first surface only.
            return {parts.radiance ? centre_ray(pixel) : CameraRay{}, address(first[pixel]), random};
        }
        const CameraRay ray = camera_ray(pixel, random.pair(kLensDimension));
        seen = integrator.first_surface(ray);
        return {ray, address(seen), random};
    }

    void trace(int count) {
        for_each_run([&](std::size_t begin, std::size_t pixels) {
            sample(begin, pixels, count,
                   [&](std::size_t pixel, std::uint32_t number, const PathSample& result) {
                       const vec3* values[] = {&result.indirect, &result.direct, &result.radiance};
                       for (std::size_t film = 0; film < films.size(); ++film) {
                           if (!films[film].empty() && !films[film].add(pixel, number, *values[film])) {
                               nan_count.fetch_add(1, std::memory_order_relaxed);
                           }
                       }
                   });
        });
        spp += count;
    }

    double largest_noise() const {
        double noise = 0;
        for (const Film& film : films) {
            noise = film.empty() ? noise : std::max(noise, film.noise());
        }
        return noise;
    }

    Film& film(PathAov aov) { return films[static_cast<std::size_t>(aov)]; }
    CheckpointHeader header() const {
        return {sample_number,
                static_cast<std::uint32_t>(size.x),
                static_cast<std::uint32_t>(size.y),
                static_cast<std::uint32_t>(spp),
                (parts.indirect ? 1u : 0u) | (parts.direct ? 2u : 0u) | (parts.radiance ? 4u : 0u),
                nan_count.load()};
    }

    PathSettings settings;
    SampleParts parts;
    ivec2 size;
    std::uint64_t scene_number;
    std::uint64_t sample_number;
    MaterialTable materials;
    TraceScene scene;
    Emitters emitters;
    PunctualLights lights;
    SkyLight sky;
    CameraRays camera;
    Integrator integrator;
    TileWorkers workers;
    std::vector<std::optional<FirstSurface>> first;  // by pixel, through its centre
    std::array<Film, 3> films;                       // in PathAov's order; empty: not asked for
    int spp = 0;
    std::atomic<std::uint64_t> nan_count = 0;
};

PathTracer::PathTracer(const FrameScene& scene, ivec2 size, const PathSettings& settings, PathParts parts)
    : state_(std::make_unique<State>(scene, size, settings, parts)) {}
PathTracer::~PathTracer() = default;

PathProgress PathTracer::render(const PathControl& control) {
    State& s = *state_;
    const PathSettings& settings = s.settings;
    const Clock::time_point start = Clock::now();
    const int first_spp = s.spp;
    PathProgress progress;
    progress.noise = s.spp >= kFirstNoiseCheck ? s.largest_noise() : std::numeric_limits<double>::infinity();
    int check = next_noise_check(s.spp);
    double seconds_a_sample = 0;
    while (true) {
        progress.spp = s.spp;
        progress.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        const double limit = static_cast<double>(settings.time_limit);
        const double target = static_cast<double>(settings.target_noise);
        progress.share = static_cast<double>(s.spp) / settings.spp;
        if (limit > 0) {
            progress.share = std::max(progress.share, progress.seconds / limit);
        }
        if (target > 0 && progress.noise > 0 && std::isfinite(progress.noise)) {
            progress.share = std::max(progress.share, std::pow(target / progress.noise, 2));
        }
        progress.share = std::min(progress.share, 1.0);
        const bool quiet = target > 0 && progress.noise <= target;
        const bool late = limit > 0 && progress.seconds >= limit && s.spp > 0;
        const bool wanted = !control.progress || control.progress(progress);
        if (s.spp >= settings.spp || quiet || late || !wanted) {
            return progress;
        }
        int count = 1;
        if (seconds_a_sample > 0) {
            double seconds = kPassSeconds;
            if (limit > 0) {
                seconds = std::min(seconds, limit - progress.seconds);
            }
            count = static_cast<int>(glm::clamp(seconds / seconds_a_sample, 1.0, double{kMostPerPass}));
        }
        s.trace(std::min({count, settings.spp - s.spp, check - s.spp}));
        seconds_a_sample = std::chrono::duration<double>(Clock::now() - start).count() / (s.spp - first_spp);
        if (s.spp == check) {
            progress.noise = target > 0 ? s.largest_noise() : progress.noise;
            check = next_noise_check(s.spp);
        }
    }
}

std::vector<float> PathTracer::image(PathAov aov) const {
    State& s = *state_;
    if (aov == PathAov::indirect || aov == PathAov::direct || aov == PathAov::radiance) {
        return s.film(aov).mean();
    }
    std::vector<float> result;
    for (const std::optional<FirstSurface>& surface : s.first) {
        if (aov == PathAov::depth) {
            result.push_back(surface ? surface->hit.t : 0);
            continue;
        }
        vec3 value(0);
        if (surface) {
            const SurfaceHit& hit = surface->hit;
            const TraceInstance& instance = s.scene.instances()[hit.instance];
            value = aov == PathAov::normal
                        ? s.materials.shading_normal(instance, hit)
                        : s.materials.evaluate(instance, hit.primitive, hit.barycentric).diffuse_albedo();
        }
        result.insert(result.end(), {value.x, value.y, value.z});
    }
    return result;
}

double PathTracer::noise(PathAov aov) const {
    return state_->film(aov).noise();
}

std::vector<float> PathTracer::coverage() const {
    std::vector<float> result;
    for (const std::optional<FirstSurface>& surface : state_->first) {
        const bool unlit =
            surface && state_->materials[state_->scene.instances()[surface->hit.instance].material].unlit;
        result.push_back(!surface ? 0.0f : unlit ? 2.0f : 1.0f);
    }
    return result;
}

int PathTracer::spp() const {
    return state_->spp;
}
std::uint64_t PathTracer::nan_count() const {
    return state_->nan_count;
}

std::vector<std::pair<std::string, std::string>> PathTracer::description(PathAov aov) const {
    const PathSettings& settings = state_->settings;
    std::vector<std::pair<std::string, std::string>> result{
        {"technique", "path"},
        {"scene", fmt::format("{:016x}", state_->scene_number)},
        {"transport", transport_name(settings.transport)},
        {"bounces", settings.unlimited ? "unlimited" : fmt::format("{}", settings.bounces)},
        {"seed", fmt::format("{}", settings.seed)},
        {"spp", fmt::format("{}", state_->spp)},
        {"nan_samples", fmt::format("{}", state_->nan_count.load())}};
    if (aov == PathAov::indirect || aov == PathAov::direct || aov == PathAov::radiance) {
        result.emplace_back("noise", fmt::format("{:.6g}", noise(aov)));
    }
    return result;
}

RayLog PathTracer::log_rays() {
    State& s = *state_;
    RayLog log;
    s.scene.log_to(&log);
    for (std::size_t pixel = 0; pixel < s.first.size(); ++pixel) {
        s.sample(pixel, 1, 1, [](std::size_t, std::uint32_t, const PathSample&) {});
    }
    s.scene.log_to(nullptr);
    return log;
}

void PathTracer::save(const std::filesystem::path& checkpoint) const {
    write_checkpoint(checkpoint, state_->header(), state_->films);
}

void PathTracer::resume(const std::filesystem::path& checkpoint) {
    const CheckpointHeader header = read_checkpoint(checkpoint, state_->header(), state_->films);
    state_->spp = static_cast<int>(header.spp);
    state_->nan_count = header.nan_count;
}

}  // namespace lanthorn::reference
