// Samples of a picture's pixels and what they add up to: what the path tracer adds to pass by pass, and the
// technique `path` frame by frame.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "gi_module/reference/film.h"
#include "gi_module/reference/integrator.h"
#include "gi_module/reference/tile_workers.h"

namespace lanthorn::reference {

// By what pixels are sampled.
struct PixelRays {
    const Integrator& integrator;
    const CameraRays& camera;
    const PathSettings& settings;
};

class PixelSamples {
  public:
    // No samples yet.
    PixelSamples(ivec2 size, const SampleParts& parts);

    // Finds what each pixel sees through its centre. O(pixels log triangles).
    void look(const PixelRays& rays, TileWorkers& workers);
    // Adds the next `count` samples to every pixel; after look() with the same rays. They are a function of
    // seed, pixel and number alone: not of `count`, nor of the threads. `between`, if there is one, is called
    // on this thread each time that another part of the picture has them.
    void trace(const PixelRays& rays, int count, TileWorkers& workers,
               const std::function<void()>& between = {});
    // The next sample of all pixels, one path after the other on this thread; it does not count.
    void trace_apart(const PixelRays& rays);
    // Forgets the samples, not what the pixels see; from here on samples have these parts.
    void begin_again(const SampleParts& parts);
    // The same with the parts there are, for rows alone: the next sample of each of their pixels is number
    // `first`, and other pixels get none until begin_again().
    void begin_piece(int first, int top, int rows);

    int spp() const { return spp_; }
    std::uint64_t nan_count() const { return nan_count_; }  // samples that were left out
    // What was read from a file: films() are then of so many.
    void set_counts(int spp, std::uint64_t nan_count);

    ivec2 size() const { return size_; }
    const SampleParts& parts() const { return parts_; }
    const std::vector<std::optional<FirstSurface>>& first() const { return first_; }  // by pixel
    // By pixel: 0 background, 1 lit, 2 unlit.
    std::vector<float> coverage(const TraceScene& scene, const MaterialTable& materials) const;

    // Of indirect, direct and radiance; empty: not asked for.
    using Films = std::array<Film, 3>;
    Films& films() { return films_; }
    const Films& films() const { return films_; }
    double largest_noise() const;

  private:
    template <class Visit>
    void for_each_run(TileWorkers& workers, std::size_t begin, std::size_t end, const Visit& visit) const;
    template <class Add>
    void sample(const PixelRays& rays, std::size_t begin, std::size_t pixels, int count,
                const Add& add) const;
    SampleStart start(const PixelRays& rays, std::size_t pixel, std::uint32_t number,
                      std::optional<FirstSurface>& seen) const;
    CameraRay camera_ray(const CameraRays& camera, std::size_t pixel, const vec2& within) const;

    ivec2 size_;
    SampleParts parts_;
    std::vector<std::optional<FirstSurface>> first_;
    Films films_;
    std::size_t begin_ = 0, end_ = 0;  // the pixels that are sampled
    int spp_ = 0;
    std::atomic<std::uint64_t> nan_count_ = 0;
};

// Noise is looked at after these numbers of samples and no others, so that a picture does not depend on how
// many were taken at once: the next one after `spp`, each about a fifth more than the last.
int next_noise_check(int spp);
inline constexpr int kFirstNoiseCheck = 16;  // samples: with fewer the estimate means little

}  // namespace lanthorn::reference
