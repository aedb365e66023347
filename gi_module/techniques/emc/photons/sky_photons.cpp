#include "gi_module/techniques/emc/photons/sky_photons.h"

#include <cmath>
#include <span>

#include "lanthorn/core/colour.h"

namespace lanthorn::gi {

double area_across(const Aabb& box, const dvec3& direction) {
    if (box.empty()) {
        return 0;
    }
    const dvec3 size = dvec3(box.upper) - dvec3(box.lower);
    return glm::dot(glm::abs(direction), dvec3(size.y * size.z, size.z * size.x, size.x * size.y));
}

SkyPhotonCells SkyPhotonCells::of(const SkyInstance& sky, const Aabb& bounds) {
    const SkyImage image = coarser(*sky.sky.lights_by(), kSkyPhotonRows);
    SkyPhotonCells result;
    result.width = image.width;
    result.height = image.height;
    const glm::dmat3 to_render(glm::transpose(sky.to_sky));
    const dvec3 scale(sky.scale());
    std::vector<double> caught;
    caught.reserve(image.radiance.size());
    double sum = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const vec2 middle((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                              (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height));
            const dvec3 lux = dvec3(image.at(x, y)) * scale * image.pixel_solid_angle(y);
            const dvec3 flux = lux * area_across(bounds, to_render * dvec3(sky_direction(middle)));
            result.flux += flux;
            caught.push_back(luminance(flux));
            sum += caught.back();
        }
    }
    if (!(sum > 0) || !std::isfinite(sum)) {
        result.flux = dvec3(0);
        return result;
    }
    result.cells.reserve(caught.size());
    double before = 0;
    for (std::size_t i = 0; i < caught.size(); ++i) {
        const auto row = static_cast<std::uint32_t>(i / image.width);
        const double probability = caught[i] / sum;
        before += probability;
        const dvec3 lux = dvec3(image.radiance[i]) * scale * image.pixel_solid_angle(row);
        result.cells.push_back(
            {static_cast<float>(before), probability > 0 ? vec3(lux / probability) : vec3(0)});
    }
    result.cells.back().cumulative = 1;
    return result;
}

void SkyPhotons::follow(const FrameScene& scene) {
    if (scene.sky == sky_ && scene.bounds == bounds_) {
        return;
    }
    sky_ = scene.sky;
    bounds_ = scene.bounds;
    flux_ = dvec3(0);
    if (!sky_) {
        return;
    }
    const SkyPhotonCells found = SkyPhotonCells::of(*sky_, bounds_);
    flux_ = found.flux;
    size_ = ivec2(found.width, found.height);
    if (!found.cells.empty()) {
        cells_ = gpu::Buffer::from(found.cells);
    }
}

void SkyPhotons::bind(const gpu::Program& program, GLuint binding) const {
    program.set("sky_cell_columns", size_.x);
    program.set("sky_cell_rows", size_.y);
    program.set("sky_to_render", glm::transpose(sky_->to_sky));
    cells_.bind_storage(binding);
}

}  // namespace lanthorn::gi
