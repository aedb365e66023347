#include "gi_module/reference/sky_light.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

constexpr std::uint32_t kRows = 64;  // of cells
constexpr double kEvenly = 0.125;    // share of the directions that do not ask how bright it is there

}  // namespace

SkyLight::SkyLight(const FrameScene& scene) {
    if (!scene.sky) {
        return;
    }
    const SkyInstance& sky = *scene.sky;
    image_ = sky.sky.lights_by();
    shown_ = sky.sky.image;
    scale_ = sky.scale();
    to_sky_ = sky.to_sky;
    coarse_ = coarser(*image_, kRows);
    double total = 0, sphere = 0;
    const auto each = [&](const auto& visit) {
        for (std::uint32_t y = 0; y < coarse_.height; ++y) {
            const double angle = coarse_.pixel_solid_angle(y);
            for (std::uint32_t x = 0; x < coarse_.width; ++x) {
                visit(angle, static_cast<double>(luminance(coarse_.at(x, y))) * angle);
            }
        }
    };
    each([&](double angle, double flux) {
        sphere += angle;
        total += flux;
    });
    double sum = 0;
    cumulative_.reserve(coarse_.radiance.size());
    each([&](double angle, double flux) {
        const double even = angle / sphere;
        sum += total > 0 ? kEvenly * even + (1 - kEvenly) * flux / total : even;
        cumulative_.push_back(sum);
    });
}

vec3 SkyLight::radiance(const vec3& direction) const {
    return image_ ? sky_radiance(*image_, to_sky_ * direction) * scale_ : vec3(0);
}

vec3 SkyLight::shown(const vec3& direction) const {
    return shown_ ? sky_radiance(*shown_, to_sky_ * direction) * scale_ : vec3(0);
}

std::size_t SkyLight::cell_of(const vec2& place) const {
    const auto index = [](float part, std::uint32_t count) {
        return std::min(static_cast<std::uint32_t>(std::max(part, 0.0f) * static_cast<float>(count)),
                        count - 1);
    };
    return std::size_t{index(place.y, coarse_.height)} * coarse_.width + index(place.x, coarse_.width);
}

float SkyLight::cell_density(std::size_t cell) const {
    const double probability = cumulative_[cell] - (cell > 0 ? cumulative_[cell - 1] : 0);
    const auto row = static_cast<std::uint32_t>(cell / coarse_.width);
    return static_cast<float>(probability / coarse_.pixel_solid_angle(row));
}

// Within a cell evenly by solid angle.
SkyLight::Sample SkyLight::draw(const vec2& u) const {
    const double wanted = static_cast<double>(u.x) * cumulative_.back();
    const auto found = std::ranges::upper_bound(cumulative_, wanted);
    const auto cell = std::min(static_cast<std::size_t>(found - cumulative_.begin()), cumulative_.size() - 1);
    const double before = cell > 0 ? cumulative_[cell - 1] : 0;
    const double within = (wanted - before) / (cumulative_[cell] - before);
    const double pi = static_cast<double>(kPi);
    const auto row = static_cast<double>(cell / coarse_.width);
    const double upper = std::cos(pi * row / coarse_.height),
                 lower = std::cos(pi * (row + 1) / coarse_.height);
    const double height = upper + (lower - upper) * static_cast<double>(u.y);
    const double longitude =
        (static_cast<double>(cell % coarse_.width) + glm::clamp(within, 0.0, 1.0)) / coarse_.width * 2 * pi -
        pi;
    const double flat = std::sqrt(std::max(1 - height * height, 0.0));
    const vec3 in_sky(flat * std::cos(longitude), height, flat * std::sin(longitude));
    Sample sample;
    sample.direction = glm::transpose(to_sky_) * in_sky;
    sample.radiance = sky_radiance(*image_, in_sky) * scale_;
    sample.density = cell_density(cell);
    return sample;
}

float SkyLight::density(const vec3& direction) const {
    return image_ ? cell_density(cell_of(sky_place(to_sky_ * direction))) : 0.0f;
}

}  // namespace lanthorn::reference
