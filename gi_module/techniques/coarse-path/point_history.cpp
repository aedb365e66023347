#include "gi_module/techniques/coarse-path/point_history.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/sampling.h"
#include "gi_module/shared/coarse_grid/same_surface.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kHistoryRun = 512;  // points that a thread takes at once

}  // namespace

void PointEstimate::add(const vec3& sum, float squares, int count) {
    if (count <= 0) {
        return;
    }
    const auto n = static_cast<float>(count);
    const float share = 1 / (samples + n);
    irradiance = (irradiance * samples + sum) * share;
    second = (second * samples + squares) * share;
    samples += n;
}

float PointEstimate::variance() const {
    if (samples < 2) {
        return 0;
    }
    const float mean = luminance(irradiance);
    return std::max(second - mean * mean, 0.0f) / (samples - 1);
}

float PointView::tolerance(float distance) const {
    return kPlaneTolerance * 2 * glm::length(camera.up) * (camera.orthographic ? 1.0f : distance);
}

// What the last frame's points know of a point (render space of that frame).
PointEstimate PointHistory::before(const vec3& position, const vec3& normal) const {
    const vec3 relative = position - view_.camera.position;
    const vec4 clip = view_.camera.clip_from_relative * vec4(relative, 1);
    PointEstimate result;
    if (!(clip.w > 0)) {
        return result;
    }
    const vec2 pixel = (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(points_.size) - 0.5f;
    // Also refuses what is not a number.
    if (!(pixel.x > -1 && pixel.y > -1 && pixel.x < static_cast<float>(points_.size.x) &&
          pixel.y < static_cast<float>(points_.size.y))) {
        return result;
    }
    const float tolerance = view_.tolerance(view_.camera.orthographic ? 1.0f : glm::length(relative));
    float total = 0;
    const auto take = [&](std::size_t index, float weight) {
        const SurfacePoint& point = points_.points[index];
        const PointEstimate& estimate = estimates_[index];
        const vec3 span = point.position - position;
        const float off = std::max(std::abs(glm::dot(span, normal)), std::abs(glm::dot(span, point.normal)));
        if (!(point.distance > 0) || !(estimate.samples > 0) || glm::dot(normal, point.normal) < kLeastTurn ||
            off > tolerance) {
            return;
        }
        result.irradiance += estimate.irradiance * weight;
        result.second += estimate.second * weight;
        result.samples += estimate.samples * weight;
        result.frames += estimate.frames * weight;
        total += weight;
    };
    const vec2 place = pixel / static_cast<float>(points_.spacing);
    const ivec2 base(glm::floor(place));
    const vec2 within = place - vec2(base);
    for (int k = 0; k < 4; ++k) {
        const ivec2 corner(k & 1, k >> 1);
        const float weight =
            (corner.x != 0 ? within.x : 1 - within.x) * (corner.y != 0 ? within.y : 1 - within.y);
        if (weight > 1e-3f && points_.has_cell(base + corner)) {
            take(points_.cell_index(base + corner), weight);
        }
    }
    if (total <= 0) {
        const ivec2 nearest(glm::floor(pixel + 0.5f));
        const auto extras = points_.extras();
        for (int y = std::max(nearest.y - 1, 0); y <= nearest.y + 1; ++y) {
            const auto word = [&](int x) { return static_cast<std::uint32_t>(std::max(x, 0) | y << 16); };
            auto found = std::ranges::lower_bound(extras, word(nearest.x - 1), {}, &SurfacePoint::pixel);
            for (; found != extras.end() && found->pixel <= word(nearest.x + 1); ++found) {
                take(points_.lattice() + static_cast<std::size_t>(found - extras.begin()), 1);
            }
        }
    }
    if (total > 0) {
        result.irradiance /= total;
        result.second /= total;
        result.samples /= total;
        result.frames /= total;
    }
    return result;
}

void PointHistory::follow(const GridPoints& points, const PointView& view,
                          std::span<const MovedInstance> movers, reference::TileWorkers& workers) {
    std::vector<PointEstimate> estimates(points.points.size());
    if (!estimates_.empty()) {
        const vec3 shift(view.origin - view_.origin);
        workers.run((points.points.size() + kHistoryRun - 1) / kHistoryRun, [&](std::size_t run) {
            const std::size_t end = std::min((run + 1) * kHistoryRun, points.points.size());
            for (std::size_t i = run * kHistoryRun; i < end; ++i) {
                const SurfacePoint& point = points.points[i];
                if (!(point.distance > 0)) {
                    continue;
                }
                PointEstimate known;
                for (const MovedInstance& mover : movers) {
                    if (known.samples > 0) {
                        break;
                    }
                    if (glm::all(glm::greaterThanEqual(point.position, mover.bounds.lower)) &&
                        glm::all(glm::lessThanEqual(point.position, mover.bounds.upper))) {
                        known = before(vec3(mover.to_before * vec4(point.position, 1)),
                                       glm::normalize(mat3(mover.to_before) * point.normal));
                    }
                }
                if (!(known.samples > 0)) {
                    known = before(point.position + shift, point.normal);
                }
                estimates[i] = known;
            }
        });
    }
    estimates_ = std::move(estimates);
    points_ = points;
    view_ = view;
}

void PointHistory::age(int frames) {
    const auto most = static_cast<float>(frames - 1);
    for (PointEstimate& estimate : estimates_) {
        if (estimate.frames > most) {
            estimate.samples *= most / estimate.frames;
            estimate.frames = most;
        }
        estimate.frames += 1;
    }
}

}  // namespace lanthorn::gi
