#include "gi_module/techniques/coarse-path/point_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "gi_module/reference/sampling.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kRun = 64;  // points that a thread takes at once

// A point off the G-buffer is rounded by its distance and by its coordinates, and its normal has 16 bits.
constexpr float kOffset = 0x1p-16f;

float offset_of(const SurfacePoint& point) {
    const vec3 p = glm::abs(point.position);
    return kOffset * std::max({p.x, p.y, p.z, point.distance});
}

struct RunResult {
    std::uint64_t rays = 0;
    std::uint64_t left_out = 0;
};

}  // namespace

void PointPaths::clear() {
    emitters_.reset();
    scene_.clear();
    samples_.clear();
    of_sky_.reset();
    sky_ = {};
}

void PointPaths::follow(const FrameScene& scene) {
    if (scene_.follow(scene) || !emitters_) {
        emitters_.emplace(scene_.scene(), scene_.materials(), &scene_.pieces());
    }
    lights_.emplace(scene);
    if (of_sky_ != scene.sky) {
        of_sky_ = scene.sky;
        sky_ = reference::SkyLight(scene);
    }
}

std::uint64_t PointPaths::trace(const GridPoints& points, std::span<const int> counts, int bounces,
                                std::uint32_t seed, std::span<PointEstimate> estimates,
                                reference::TileWorkers& workers) {
    if (size_ != points.size || samples_.empty()) {
        size_ = points.size;
        samples_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y), 0);
    }
    reference::PathSettings settings;
    settings.bounces = bounces;
    settings.seed = seed;
    const reference::Integrator integrator(scene_.scene(), scene_.materials(), *emitters_, *lights_, sky_,
                                           settings);
    std::vector<RunResult> runs((points.points.size() + kRun - 1) / kRun);
    workers.run(runs.size(), [&](std::size_t run) {
        const std::size_t end = std::min((run + 1) * kRun, points.points.size());
        std::vector<reference::IrradianceStart> starts;
        for (std::size_t i = run * kRun; i < end; ++i) {
            const SurfacePoint& point = points.points[i];
            const ivec2 xy = point.xy();
            const auto pixel = static_cast<std::uint32_t>(xy.y * size_.x + xy.x);
            for (int k = 0; k < counts[i]; ++k) {
                starts.push_back({point.position, point.normal, offset_of(point),
                                  reference::RandomNumbers(seed, pixel, samples_[pixel]++)});
            }
        }
        std::vector<vec3> light(starts.size());
        runs[run].rays = integrator.irradiance(starts, light);
        std::size_t next = 0;
        for (std::size_t i = run * kRun; i < end; ++i) {
            vec3 sum(0);
            float squares = 0;
            int good = 0;
            for (int k = 0; k < counts[i]; ++k, ++next) {
                const float l = luminance(light[next]);
                if (std::isfinite(l)) {
                    sum += light[next];
                    squares += l * l;
                    ++good;
                } else {
                    ++runs[run].left_out;
                }
            }
            estimates[i].add(sum, squares, good);
        }
    });
    std::uint64_t rays = 0;
    for (const RunResult& run : runs) {
        rays += run.rays;
        nan_count_ += run.left_out;
    }
    return rays;
}

}  // namespace lanthorn::gi
