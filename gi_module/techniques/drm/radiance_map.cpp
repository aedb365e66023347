#include "gi_module/techniques/drm/radiance_map.h"

#include <algorithm>
#include <span>

#include "gi_module/techniques/drm/sample_pictures.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr float kLeastDistance = 1e-6f;  // of the scene's diagonal: what is nearer is taken to be that far
constexpr int kSampleResolution = 64;    // texels a side of a face of what a sample sees
constexpr int kSecondTexels = 32;        // a side of the picture that samples of the second bounce are of
constexpr GLuint kHidingUnit = 14;       // and the next: beside those of all programs that ask samples

int form_of(SolidAngle kind) {
    switch (kind) {
        case SolidAngle::eq_14:
        case SolidAngle::disc:
            return 1;
        case SolidAngle::eq_13:
            return 2;
        case SolidAngle::eq_15:
        case SolidAngle::eq_11:
            break;
    }
    return 0;
}

}  // namespace

void RadianceMap::make(const render::LightInputs& inputs, const DrmSettings& settings, ExactRays* exact,
                       const gpu::Buffer& bad_values) {
    const render::LightMaps& light_maps = inputs.light_maps;
    pictures_ = choose_pictures(light_maps.light_data(), light_maps.punctual_count(), inputs.scene.bounds,
                                settings.lights);
    samples_ = direct_samples_ = settings.samples * settings.samples * pictures_.count();
    faces_drawn_ = mirrored_ = sample_pictures_ = 0;
    hides_ = false;
    by_area_ = form_of(settings.solid_angle);
    const float diagonal = inputs.scene.diagonal();
    least_distance_ = kLeastDistance * diagonal * kLeastDistance * diagonal;
    if (samples_ == 0) {
        return;
    }
    make_room(samples_);
    const int cell = std::max(1, (settings.texels + settings.samples - 1) / settings.samples);
    faces_drawn_ = maps_.draw(inputs, pictures_, std::clamp(cell * settings.samples, 16, 256));
    if (exact != nullptr && settings.mips == DrmMips::all) {
        follow_mirrored(inputs, cell * settings.samples, *exact);
    }
    sample(inputs, maps_, {settings.samples, cell, pictures_.count(), 0}, settings, bad_values);
    if (samples_look(settings)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "sample_pictures");
        look_from_samples(inputs, settings, bad_values);
    }
    glMemoryBarrier(GL_UNIFORM_BARRIER_BIT);
}

// A larger list holds what the smaller one held.
void RadianceMap::make_room(int samples) {
    const std::size_t room = std::max<std::size_t>(static_cast<std::size_t>(samples), kMostBlockSamples);
    if (list_.bytes() < room * sizeof(RadianceSample)) {
        list_ = gpu::Buffer(room * sizeof(RadianceSample));
    }
}

void RadianceMap::sample(const render::LightInputs& inputs, const PictureMaps& maps, const Grid& grid,
                         const DrmSettings& settings, const gpu::Buffer& bad_values) {
    if (!program_) {
        program_ = gpu::Program({"gi_module/techniques/drm/radiance_samples.comp"});
    }
    const float diagonal = inputs.scene.diagonal();
    maps.bind(program_, inputs);
    list_.bind_storage(kSamplesBinding);
    bad_values.bind_storage(5);
    first_ends_.bind_storage(6);
    ends_.bind_storage(7);
    program_.set("has_mirrored", grid.first == 0 && mirrored_ > 0 ? 1 : 0);
    program_.set(
        "has_place",
        settings.visibility == DrmVisibility::maps || (grid.first == 0 && samples_look(settings)) ? 1 : 0);
    program_.set("first", static_cast<unsigned>(grid.first));
    program_.set("side", grid.side);
    program_.set("cell_texels", grid.cell_texels);
    program_.set("mips", static_cast<int>(settings.mips));
    program_.set("solid_angle", static_cast<int>(settings.solid_angle));
    program_.set("diagonal2", diagonal * diagonal);
    glDispatchCompute(static_cast<GLuint>(grid.side * grid.side), static_cast<GLuint>(grid.pictures), 1);
    wait_for_shaders();
}

void RadianceMap::look_from_samples(const render::LightInputs& inputs, const DrmSettings& settings,
                                    const gpu::Buffer& bad_values) {
    std::vector<RadianceSample> samples = read();
    const LightPictures seen = pictures_of_samples(samples, settings.solid_angle, inputs.scene.diagonal(),
                                                   settings.samples * settings.samples);
    sample_pictures_ = seen.count();
    faces_drawn_ += sample_maps_.draw(inputs, seen, kSampleResolution);
    const int second = settings.second * settings.second * seen.count();
    make_room(direct_samples_ + second);
    list_.write(0, std::span<const RadianceSample>(samples));
    hides_ = settings.visibility == DrmVisibility::maps;
    hiding_maps_ = &sample_maps_;
    if (second > 0) {
        sample(inputs, sample_maps_,
               {settings.second, kSecondTexels / settings.second, seen.count(), direct_samples_}, settings,
               bad_values);
        samples_ += second;
        if (hides_) {
            hide_all(inputs, settings);
        }
    }
}

// Those of the second bounce as well, all in one array.
void RadianceMap::hide_all(const render::LightInputs& inputs, const DrmSettings& settings) {
    std::vector<RadianceSample> samples = read();
    const LightPictures seen = pictures_of_samples(samples, settings.solid_angle, inputs.scene.diagonal(),
                                                   settings.samples * settings.samples);
    sample_pictures_ = seen.count();
    faces_drawn_ += all_maps_.draw(inputs, seen, kSampleResolution);
    list_.write(0, std::span<const RadianceSample>(samples));
    hiding_maps_ = &all_maps_;
}

// Of all pictures, `width` texels a side.
void RadianceMap::follow_mirrored(const render::LightInputs& inputs, int width, ExactRays& exact) {
    const int texels = width * width * pictures_.count();
    const auto count = static_cast<std::size_t>(texels);
    if (!mirrored_program_) {
        mirrored_program_ = gpu::Program({"gi_module/techniques/drm/mirrored_light.comp"});
        ray_count_ = gpu::Buffer(sizeof(std::uint32_t));
    }
    if (rays_.bytes() < count * sizeof(SpecularRay)) {
        rays_ = gpu::Buffer(count * sizeof(SpecularRay));
    }
    ray_count_.clear();
    maps_.bind(mirrored_program_, inputs);
    ray_count_.bind_storage(0);
    rays_.bind_storage(1);
    mirrored_program_.set("width", width);
    glDispatchCompute(static_cast<GLuint>((width * width + 63) / 64), static_cast<GLuint>(pictures_.count()),
                      1);
    wait_for_shaders();
    mirrored_ = static_cast<int>(ray_count_.read<std::uint32_t>(1).front());
    if (mirrored_ == 0) {
        return;
    }
    const std::vector<SpecularRay> rays = rays_.read<SpecularRay>(static_cast<std::size_t>(mirrored_));
    std::vector<std::uint32_t> first(count, 0);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        first[rays[i].pixel] = static_cast<std::uint32_t>(i) + 1;
    }
    upload(first_ends_, first, 1);
    upload(ends_, exact.trace(std::span<const SpecularRay>(rays)), 1);
}

std::vector<RadianceSample> RadianceMap::read() const {
    return samples_ > 0 ? list_.read<RadianceSample>(static_cast<std::size_t>(samples_))
                        : std::vector<RadianceSample>();
}

void RadianceMap::bind(const gpu::Program& program, bool in_block) const {
    if (in_block) {
        list_.bind_uniform(kSampleBlockBinding);
    } else {
        list_.bind_storage(kSamplesBinding);
    }
    program.set("sample_count", samples_);
    program.set("by_area", by_area_);
    if (hides_) {
        program.set("hiding_distance", static_cast<int>(kHidingUnit));
        program.set("hiding_normals", static_cast<int>(kHidingUnit + 1));
        hiding_maps_->distance().bind(kHidingUnit);
        hiding_maps_->normals().bind(kHidingUnit + 1);
    }
    program.set("least_distance", least_distance_);
}

}  // namespace lanthorn::gi
