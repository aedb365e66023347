#include "lanthorn/reference/path_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "gi_module/reference/checkpoint.h"
#include "gi_module/reference/pixel_samples.h"
#include "gi_module/reference/ray_log.h"
#include "gi_module/reference/scene_hash.h"
#include "gi_module/reference/tile_workers.h"
#include "lanthorn/core/error.h"

namespace lanthorn::reference {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPassSeconds = 0.2;  // about how long a pass may take, so that cancelling is felt at once
constexpr int kMostPerPass = 256;     // samples
constexpr int kPieceSamples = 4;      // of a pass of a piece

}  // namespace

struct PathTracer::State {
    State(const FrameScene& frame, ivec2 image_size, const PathSettings& path_settings, PathParts path_parts)
        : settings(path_settings),
          scene_number(reference::scene_hash(frame)),
          sample_number(sample_hash(frame, image_size, path_settings)),
          materials(*frame.assets),
          scene(frame, materials),
          emitters(scene, materials),
          lights(frame),
          sky(frame),
          camera(frame.camera, image_size),
          integrator(scene, materials, emitters, lights, sky, path_settings),
          workers(path_settings.threads),
          samples(image_size, {path_parts.indirect, path_parts.direct, path_parts.radiance}) {
        samples.look(rays(), workers);
    }

    PixelRays rays() const { return {integrator, camera, settings}; }
    Film& film(PathAov aov) { return samples.films()[static_cast<std::size_t>(aov)]; }
    CheckpointHeader header() const {
        const SampleParts& parts = samples.parts();
        return {sample_number,
                static_cast<std::uint32_t>(samples.size().x),
                static_cast<std::uint32_t>(samples.size().y),
                static_cast<std::uint32_t>(samples.spp()),
                (parts.indirect ? 1u : 0u) | (parts.direct ? 2u : 0u) | (parts.radiance ? 4u : 0u),
                samples.nan_count(),
                0,
                0,
                static_cast<std::uint32_t>(samples.size().y),
                0};
    }
    CheckpointHeader header(const PathPiece& piece) const {
        CheckpointHeader of_piece = header();
        of_piece.spp = static_cast<std::uint32_t>(piece.samples);
        of_piece.first = static_cast<std::uint32_t>(piece.first);
        of_piece.top = static_cast<std::uint32_t>(piece.top);
        of_piece.rows = static_cast<std::uint32_t>(piece.rows);
        return of_piece;
    }
    // Of another number of samples, too: a block that a run with fewer ended in.
    static void check_samples(const CheckpointHeader& found, const PathPiece& piece,
                              const std::filesystem::path& file) {
        if (found.spp != static_cast<std::uint32_t>(piece.samples)) {
            throw InputError(file.string(), "",
                             fmt::format("found {} samples, expected {}", found.spp, piece.samples));
        }
    }

    PathSettings settings;
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
    PixelSamples samples;
};

PathTracer::PathTracer(const FrameScene& scene, ivec2 size, const PathSettings& settings, PathParts parts)
    : state_(std::make_unique<State>(scene, size, settled(settings, parts.radiance), parts)) {}
PathTracer::~PathTracer() = default;

PathProgress PathTracer::render(const PathControl& control) {
    State& s = *state_;
    const PathSettings& settings = s.settings;
    const Clock::time_point start = Clock::now();
    const int first_spp = s.samples.spp();
    PathProgress progress;
    progress.noise =
        first_spp >= kFirstNoiseCheck ? s.samples.largest_noise() : std::numeric_limits<double>::infinity();
    int check = next_noise_check(s.samples.spp());
    double seconds_a_sample = 0;
    while (true) {
        progress.spp = s.samples.spp();
        progress.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        const double limit = static_cast<double>(settings.time_limit);
        const double target = static_cast<double>(settings.target_noise);
        progress.share = static_cast<double>(progress.spp) / settings.spp;
        if (limit > 0) {
            progress.share = std::max(progress.share, progress.seconds / limit);
        }
        if (target > 0 && progress.noise > 0 && std::isfinite(progress.noise)) {
            progress.share = std::max(progress.share, std::pow(target / progress.noise, 2));
        }
        progress.share = std::min(progress.share, 1.0);
        const bool quiet = target > 0 && progress.noise <= target;
        const bool late = limit > 0 && progress.seconds >= limit && progress.spp > 0;
        const bool wanted = !control.progress || control.progress(progress);
        if (progress.spp >= settings.spp || quiet || late || !wanted) {
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
        s.samples.trace(s.rays(), std::min({count, settings.spp - progress.spp, check - progress.spp}),
                        s.workers);
        seconds_a_sample =
            std::chrono::duration<double>(Clock::now() - start).count() / (s.samples.spp() - first_spp);
        if (s.samples.spp() == check) {
            progress.noise = target > 0 ? s.samples.largest_noise() : progress.noise;
            check = next_noise_check(s.samples.spp());
        }
    }
}

std::vector<float> PathTracer::image(PathAov aov) const {
    State& s = *state_;
    if (aov == PathAov::indirect || aov == PathAov::direct || aov == PathAov::radiance) {
        return s.film(aov).mean();
    }
    std::vector<float> result;
    for (const std::optional<FirstSurface>& surface : s.samples.first()) {
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
    return state_->samples.coverage(state_->scene, state_->materials);
}

int PathTracer::spp() const {
    return state_->samples.spp();
}
std::uint64_t PathTracer::nan_count() const {
    return state_->samples.nan_count();
}

std::vector<std::pair<std::string, std::string>> PathTracer::description(PathAov aov) const {
    const PathSettings& settings = state_->settings;
    std::vector<std::pair<std::string, std::string>> result{
        {"technique", "path"},
        {"scene", fmt::format("{:016x}", state_->scene_number)},
        {"transport", transport_name(settings.transport)},
        {"bounces", settings.unlimited ? "unlimited" : fmt::format("{}", settings.bounces)},
        {"seed", fmt::format("{}", settings.seed)},
        {"spp", fmt::format("{}", state_->samples.spp())},
        {"nan_samples", fmt::format("{}", state_->samples.nan_count())}};
    if (aov == PathAov::indirect || aov == PathAov::direct || aov == PathAov::radiance) {
        result.emplace_back("noise", fmt::format("{:.6g}", noise(aov)));
    }
    return result;
}

std::vector<PathPiece> path_pieces(ivec2 size, int spp, int bands) {
    std::vector<PathPiece> pieces;
    constexpr int kBlock = static_cast<int>(Film::kBlock);
    bands = std::clamp(bands, 1, std::max(size.y, 1));
    for (int first = 0; first < spp; first += kBlock) {
        for (int band = 0; band < bands; ++band) {
            const auto edge = [&](int i) {
                return static_cast<int>(static_cast<std::int64_t>(size.y) * i / bands);
            };
            pieces.push_back({first, std::min(kBlock, spp - first), edge(band), edge(band + 1) - edge(band)});
        }
    }
    return pieces;
}

bool PathTracer::trace_piece(const PathPiece& piece, const std::filesystem::path& file,
                             const PathControl& control) {
    State& s = *state_;
    s.samples.begin_piece(piece.first, piece.top, piece.rows);
    const Clock::time_point start = Clock::now();
    for (int done = 0; done < piece.samples;) {
        const int count = std::min(kPieceSamples, piece.samples - done);
        s.samples.trace(s.rays(), count, s.workers);
        done += count;
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        const double share = static_cast<double>(done) / piece.samples;
        if (control.progress &&
            !control.progress({done, seconds, share, std::numeric_limits<double>::infinity()})) {
            return false;
        }
    }
    write_checkpoint(file, s.header(piece), s.samples.films());
    return true;
}

void PathTracer::add_up(const std::vector<PathPiece>& pieces,
                        const std::vector<std::filesystem::path>& files) {
    State& s = *state_;
    s.samples.begin_again(s.samples.parts());
    PixelSamples::Films read = s.samples.films();
    int spp = 0;
    std::uint64_t nan_count = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const CheckpointHeader header = read_checkpoint(files.at(i), s.header(pieces[i]), read);
        State::check_samples(header, pieces[i], files[i]);
        for (std::size_t film = 0; film < read.size(); ++film) {
            if (!read[film].empty()) {
                s.samples.films()[film].add_block(read[film], header.begin(), header.pixels());
            }
        }
        spp = std::max(spp, pieces[i].first + pieces[i].samples);
        nan_count += header.nan_count;
    }
    s.samples.set_counts(spp, nan_count);
}

bool PathTracer::has_piece(const PathPiece& piece, const std::filesystem::path& file) const {
    try {
        PixelSamples::Films read = state_->samples.films();
        State::check_samples(read_checkpoint(file, state_->header(piece), read), piece, file);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

RayLog PathTracer::log_rays() {
    State& s = *state_;
    RayLog log;
    s.scene.log_to(&log);
    s.samples.trace_apart(s.rays());
    s.scene.log_to(nullptr);
    return log;
}

void PathTracer::save(const std::filesystem::path& checkpoint) const {
    write_checkpoint(checkpoint, state_->header(), state_->samples.films());
}

void PathTracer::resume(const std::filesystem::path& checkpoint) {
    const CheckpointHeader header = read_checkpoint(checkpoint, state_->header(), state_->samples.films());
    state_->samples.set_counts(static_cast<int>(header.spp), header.nan_count);
}

}  // namespace lanthorn::reference
