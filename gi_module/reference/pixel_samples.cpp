#include "gi_module/reference/pixel_samples.h"

#include <algorithm>

namespace lanthorn::reference {

namespace {

constexpr std::size_t kRun = 256;            // pixels that a thread takes at once
constexpr std::size_t kSmallest = 8 * kRun;  // pixels that several threads still share well
constexpr std::size_t kPart = 1 << 14;       // samples between two calls of `between`: some 20 ms
constexpr std::uint32_t kLensDimension = 0xffffffu;

}  // namespace

PixelSamples::PixelSamples(ivec2 size, const SampleParts& parts)
    : size_(size), first_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {
    begin_again(parts);
}

void PixelSamples::begin_again(const SampleParts& parts) {
    parts_ = parts;
    const bool wanted[] = {parts_.indirect, parts_.direct, parts_.radiance};
    for (std::size_t i = 0; i < films_.size(); ++i) {
        films_[i] = wanted[i] ? Film(size_) : Film();
    }
    begin_ = 0;
    end_ = first_.size();
    set_counts(0, 0);
}

void PixelSamples::begin_piece(int first, int top, int rows) {
    begin_again(parts_);
    const auto width = static_cast<std::size_t>(size_.x);
    begin_ = static_cast<std::size_t>(top) * width;
    end_ = begin_ + static_cast<std::size_t>(rows) * width;
    set_counts(first, 0);
}

void PixelSamples::set_counts(int spp, std::uint64_t nan_count) {
    spp_ = spp;
    nan_count_ = nan_count;
}

CameraRay PixelSamples::camera_ray(const CameraRays& camera, std::size_t pixel, const vec2& within) const {
    const auto across = static_cast<std::size_t>(size_.x);
    const std::size_t row = pixel / across;
    return camera.ray(static_cast<float>(pixel % across) + within.x, static_cast<float>(row) + within.y);
}

// Pixels from `begin` on in runs of neighbours, each run on one thread: visit(first, number of pixels).
template <class Visit>
void PixelSamples::for_each_run(TileWorkers& workers, std::size_t begin, std::size_t end,
                                const Visit& visit) const {
    workers.run((end - begin + kRun - 1) / kRun, [&](std::size_t run) {
        const std::size_t first = begin + run * kRun;
        visit(first, std::min(kRun, end - first));
    });
}

void PixelSamples::look(const PixelRays& rays, TileWorkers& workers) {
    for_each_run(workers, 0, first_.size(), [&](std::size_t begin, std::size_t pixels) {
        for (std::size_t pixel = begin; pixel < begin + pixels; ++pixel) {
            first_[pixel] = rays.integrator.first_surface(camera_ray(rays.camera, pixel, vec2(0.5f)));
        }
    });
}

// `seen` holds what the start refers to.
SampleStart PixelSamples::start(const PixelRays& rays, std::size_t pixel, std::uint32_t number,
                                std::optional<FirstSurface>& seen) const {
    const RandomNumbers random(rays.settings.seed, static_cast<std::uint32_t>(pixel), number);
    const auto address = [](const std::optional<FirstSurface>& s) { return s ? &*s : nullptr; };
    if (!rays.settings.antialias) {
        // The ray itself matters to what lies before the first surface only.
        return {parts_.radiance ? camera_ray(rays.camera, pixel, vec2(0.5f)) : CameraRay{},
                address(first_[pixel]), random};
    }
    const CameraRay ray = camera_ray(rays.camera, pixel, random.pair(kLensDimension));
    seen = rays.integrator.first_surface(ray);
    return {ray, address(seen), random};
}

// The next `count` samples of some neighbouring pixels, to add(pixel, number, sample). Of all pixels before
// the next number, kLanes at a time.
template <class Add>
void PixelSamples::sample(const PixelRays& rays, std::size_t begin, std::size_t pixels, int count,
                          const Add& add) const {
    std::array<SampleStart, kLanes> starts;
    std::array<std::optional<FirstSurface>, kLanes> seen;
    std::array<PathSample, kLanes> results;
    std::size_t pixel = begin;
    auto number = static_cast<std::uint32_t>(spp_);
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
            starts[lanes] = start(rays, pixel, number, seen[lanes]);
        }
        rays.integrator.sample(std::span(starts).first(lanes), parts_, results);
        pixel = first_pixel;
        number = first_number;
        for (std::size_t lane = 0; lane < lanes; ++lane, next()) {
            add(pixel, number, results[lane]);
        }
    }
}

void PixelSamples::trace(const PixelRays& rays, int count, TileWorkers& workers,
                         const std::function<void()>& between) {
    const auto visit = [&](std::size_t begin, std::size_t pixels) {
        sample(rays, begin, pixels, count,
               [&](std::size_t pixel, std::uint32_t number, const PathSample& result) {
                   const vec3* values[] = {&result.indirect, &result.direct, &result.radiance};
                   for (std::size_t film = 0; film < films_.size(); ++film) {
                       if (!films_[film].empty() && !films_[film].add(pixel, number, *values[film])) {
                           nan_count_.fetch_add(1, std::memory_order_relaxed);
                       }
                   }
               });
    };
    const std::size_t part =
        between ? std::max(kSmallest, kPart / static_cast<std::size_t>(count)) : first_.size();
    for (std::size_t begin = begin_; begin < end_; begin += part) {
        for_each_run(workers, begin, std::min(end_, begin + part), visit);
        if (between) {
            between();
        }
    }
    spp_ += count;
}

void PixelSamples::trace_apart(const PixelRays& rays) {
    for (std::size_t pixel = 0; pixel < first_.size(); ++pixel) {
        sample(rays, pixel, 1, 1, [](std::size_t, std::uint32_t, const PathSample&) {});
    }
}

std::vector<float> PixelSamples::coverage(const TraceScene& scene, const MaterialTable& materials) const {
    std::vector<float> result;
    result.reserve(first_.size());
    for (const std::optional<FirstSurface>& surface : first_) {
        const bool unlit = surface && materials[scene.instances()[surface->hit.instance].material].unlit;
        result.push_back(!surface ? 0.0f : unlit ? 2.0f : 1.0f);
    }
    return result;
}

double PixelSamples::largest_noise() const {
    double noise = 0;
    for (const Film& film : films_) {
        noise = film.empty() ? noise : std::max(noise, film.noise());
    }
    return noise;
}

int next_noise_check(int spp) {
    int check = kFirstNoiseCheck;
    while (check <= spp) {
        check += std::max(check / 10 * 2, 2);
    }
    return check;
}

}  // namespace lanthorn::reference
