#include "gi_module/techniques/emc/gather/near_pixels.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kReach = 4;           // cells of the grid, that a pixel may be from a lamp
constexpr std::size_t kLamps = 16;  // in view, the nearest ones
constexpr int kMostSide = 48;       // pixels, of a square

}  // namespace

void NearPixels::build_programs() {
    if (select_) {
        return;
    }
    select_ = gpu::Program({"gi_module/techniques/emc/gather/near_select.comp"});
    place_ = gpu::Program({"gi_module/techniques/emc/gather/near_points.comp"});
    show_ = gpu::Program({"gi_module/techniques/emc/gather/near_show.comp"});
    found_.resize(kLamps * kMostSide * kMostSide);
    squares_ = gpu::Buffer(kLamps * sizeof(vec4));
    pixels_ = gpu::Buffer(kMost * sizeof(std::uint32_t));
}

std::vector<vec4> NearPixels::squares(const render::FrameInputs& inputs, int side) const {
    struct Seen {
        float distance;
        vec4 square;
    };
    std::vector<Seen> seen;
    const vec2 size(inputs.gbuffer.size());
    for (std::size_t i = 0; i < close_.lamps().size(); ++i) {
        const vec3 relative = vec3(close_.lamps()[i]) - inputs.camera.position;
        const vec4 clip = inputs.camera.clip_from_relative * vec4(relative, 1);
        if (!(clip.w > 0)) {
            continue;
        }
        const vec2 first = (vec2(clip) / clip.w * 0.5f + 0.5f) * size - 0.5f * static_cast<float>(side);
        if (first.x > -static_cast<float>(side) && first.y > -static_cast<float>(side) && first.x < size.x &&
            first.y < size.y) {
            seen.push_back({glm::length(relative), vec4(glm::floor(first), static_cast<float>(i), 0)});
        }
    }
    std::ranges::stable_sort(seen, {}, &Seen::distance);
    seen.resize(std::min(seen.size(), kLamps));
    std::vector<vec4> result;
    std::ranges::transform(seen, std::back_inserter(result), &Seen::square);
    return result;
}

void NearPixels::shoot(const render::FrameInputs& inputs, const RayScene& rays, LitMaps& lit,
                       const SurfacePoints& points, ivec2 grid, int stride) {
    close_.begin(inputs, lit.texels().all_places() + CloseHits::kSlots);
    count_ = 0;
    const int side = std::min(2 * kReach * stride, kMostSide);
    const std::vector<vec4> around = squares(inputs, side);
    if (around.empty()) {
        return;
    }
    build_programs();
    squares_.write(0, std::span<const vec4>(around));
    found_.clear();
    use_surfaces(select_, inputs, 4);
    squares_view_.bind(0, squares_, GL_RGBA32F);
    lamps_view_.bind(1, close_.lamp_places(), GL_RGBA32F);
    grid_view_.bind(2, points.points(), GL_RGBA32F);
    select_.set("squares", 0);
    select_.set("lamps", 1);
    select_.set("points", 2);
    select_.set("square_count", static_cast<int>(around.size()));
    select_.set("side", side);
    select_.set("grid", grid);
    select_.set("stride", stride);
    const ivec2 size = inputs.gbuffer.size();
    select_.set("reach", static_cast<float>(kReach * stride) * 2 * glm::length(inputs.camera.up) /
                             static_cast<float>(size.y));
    found_.bind_storage(7);
    dispatch_items(static_cast<int>(around.size()) * side * side);
    wait_for_shaders();
    std::vector<std::uint32_t> pixels = found_.read();
    std::ranges::sort(pixels);
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    pixels.resize(std::min<std::size_t>(pixels.size(), kMost));
    count_ = static_cast<int>(pixels.size());
    if (count_ == 0) {
        return;
    }
    pixels_.write(0, std::span<const std::uint32_t>(pixels));
    points_.resize(kMost, 16, kRays);
    points_.fill(count_);
    use_surfaces(place_, inputs, 4);
    pixels_view_.bind(0, pixels_, GL_R32UI);
    place_.set("pixels", 0);
    place_.set("pixel_count", count_);
    points_.bind_storage();
    dispatch_items(count_);
    wait_for_shaders();
    RayScene own = rays;
    own.close = &close_;
    hits_.forget();
    close_.release();
    hits_.shoot(points_, own);
}

void NearPixels::show(const render::FrameInputs& inputs, const RayScene& rays, LitMaps& lit,
                      const gpu::Texture& picture, const gpu::Buffer& bad_values) {
    if (count_ == 0) {
        return;
    }
    RayScene own = rays;
    own.close = &close_;
    hits_.collect(own);
    lit.light_close(inputs, rays.maps, rays.settings, close_, bad_values);
    const gpu::Buffer& irradiance = hits_.shade(points_, lit.radiosity());
    show_.use();
    points_view_.bind(0, points_.points(), GL_RGBA32F);
    irradiance_view_.bind(1, irradiance, GL_RGBA32F);
    pixels_view_.bind(2, pixels_, GL_R32UI);
    show_.set("points", 0);
    show_.set("irradiance", 1);
    show_.set("pixels", 2);
    show_.set("pixel_count", count_);
    show_.set("width", inputs.gbuffer.size().x);
    picture.bind_image(0, GL_WRITE_ONLY);
    dispatch_items(count_);
    wait_for_shaders();
}

}  // namespace lanthorn::gi
