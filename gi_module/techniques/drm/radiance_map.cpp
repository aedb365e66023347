#include "gi_module/techniques/drm/radiance_map.h"

#include <algorithm>
#include <span>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr float kNear = 1e-5f;           // of the scene's diagonal
constexpr float kLeastDistance = 1e-6f;  // likewise: what is nearer is taken to be that far

template <class T>
void upload(gpu::Buffer& buffer, const std::vector<T>& data, std::size_t least) {
    const std::size_t bytes = std::max(data.size(), least) * sizeof(T);
    if (buffer.bytes() < bytes) {
        buffer = gpu::Buffer(bytes);
    }
    buffer.write(0, std::span<const T>(data));
}

Frustum frustum_of(const render::LightData& light, int face) {
    Frustum frustum = Frustum::of_cube_face(light.position, face);
    frustum.cut(light.direction);
    return frustum;
}

}  // namespace

void RadianceMap::make(const render::LightInputs& inputs, const DrmSettings& settings, ExactRays* exact,
                       const gpu::Buffer& bad_values) {
    const render::LightMaps& light_maps = inputs.light_maps;
    pictures_ = choose_pictures(light_maps.light_data(), light_maps.punctual_count(), inputs.scene.bounds,
                                settings.lights);
    samples_ = settings.samples * settings.samples * pictures_.count();
    faces_drawn_ = mirrored_ = 0;
    by_area_ = settings.solid_angle == SolidAngle::eq_14 || settings.solid_angle == SolidAngle::disc;
    const float diagonal = inputs.scene.diagonal();
    least_distance_ = kLeastDistance * diagonal * kLeastDistance * diagonal;
    if (samples_ == 0) {
        return;
    }
    // Never shorter than the uniform blocks that the shaders declare.
    upload(lights_, pictures_.lights, render::kMaxUniformLights);
    upload(shapes_, pictures_.shapes, 1);
    const std::size_t room = std::max<std::size_t>(static_cast<std::size_t>(samples_), kMostBlockSamples);
    if (list_.bytes() < room * sizeof(RadianceSample)) {
        list_ = gpu::Buffer(room * sizeof(RadianceSample));
    }
    const int cell = std::max(1, (settings.texels + settings.samples - 1) / settings.samples);
    draw(inputs, std::clamp(cell * settings.samples, 16, 256));

    if (exact != nullptr && settings.mips == DrmMips::all) {
        follow_mirrored(inputs, cell * settings.samples, *exact);
    }
    if (!program_) {
        program_ = gpu::Program({"gi_module/techniques/drm/radiance_samples.comp"});
    }
    bind_pictures(program_, inputs);
    list_.bind_storage(kSamplesBinding);
    bad_values.bind_storage(5);
    first_ends_.bind_storage(6);
    ends_.bind_storage(7);
    program_.set("has_mirrored", mirrored_ > 0 ? 1 : 0);
    program_.set("side", settings.samples);
    program_.set("cell_texels", cell);
    program_.set("mips", static_cast<int>(settings.mips));
    program_.set("solid_angle", static_cast<int>(settings.solid_angle));
    program_.set("diagonal2", diagonal * diagonal);
    glDispatchCompute(static_cast<GLuint>(settings.samples * settings.samples),
                      static_cast<GLuint>(pictures_.count()), 1);
    wait_for_shaders();
    glMemoryBarrier(GL_UNIFORM_BARRIER_BIT);
}

void RadianceMap::bind_pictures(const gpu::Program& program, const render::LightInputs& inputs) const {
    program.use();
    lights_.bind_storage(render::kLightsBinding);
    shapes_.bind_storage(kPicturesBinding);
    inputs.gpu_scene.bind_materials();
    const render::LightMaps& light_maps = inputs.light_maps;
    const gpu::Texture* maps[] = {&light_maps.distance(), &light_maps.normals(), &light_maps.albedo(),
                                  &maps_.distance(),      &maps_.normals(),      &maps_.albedo()};
    const char* names[] = {"light_distance", "light_normals", "light_albedo",
                           "lamp_distance",  "lamp_normals",  "lamp_albedo"};
    for (GLuint unit = 0; unit < 6; ++unit) {
        maps[unit]->bind(unit);
        program.set(names[unit], static_cast<int>(unit));
    }
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
    bind_pictures(mirrored_program_, inputs);
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

// What emissive surfaces see.
void RadianceMap::draw(const render::LightInputs& inputs, int resolution) {
    int layers = 0;
    for (const LightPicture& shape : pictures_.shapes) {
        layers += shape.drawn_here != 0 ? 6 : 0;
    }
    maps_.allocate(resolution, layers);
    if (layers == 0) {
        return;
    }
    lamp_program_.prepare(inputs.gpu_scene.variants());
    lights_.bind_storage(render::kLightsBinding);
    lamp_program_.set("near", kNear * inputs.scene.diagonal());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    for (std::size_t i = 0; i < pictures_.lights.size(); ++i) {
        if (pictures_.shapes[i].drawn_here == 0) {
            continue;
        }
        render::LightData light = pictures_.lights[i];
        light.texel = 2 / static_cast<float>(resolution);
        lamp_program_.set("light_index", static_cast<int>(i));
        lamp_program_.set("light_position", light.position);
        lamp_program_.set("light_direction", light.direction);
        for (int face = 0; face < 6; ++face) {
            draw_face(inputs, light, face);
        }
    }
    glDisable(GL_DEPTH_TEST);
}

void RadianceMap::draw_face(const render::LightInputs& inputs, const render::LightData& light, int face) {
    const Frustum frustum = frustum_of(light, face);
    const render::TexelSize texel{light.position, light.texel, 0};
    visible_.clear();
    for (const std::uint32_t i : inputs.gpu_scene.instances(render::DrawSet::opaque_and_mask)) {
        if (!frustum.touches(inputs.scene.instances[i].bounds)) {
            continue;
        }
        const std::uint32_t level = inputs.gpu_scene.level(i, texel);
        if (level != render::GpuScene::kTooSmall) {
            visible_.push_back({i, level});
        }
    }
    maps_.begin(static_cast<int>(light.first_layer) + face);
    if (!visible_.empty()) {
        lamp_program_.set("face", face);
        inputs.gpu_scene.draw(lamp_program_, visible_, render::Culling::none);
        ++faces_drawn_;
    }
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
    program.set("by_area", by_area_ ? 1 : 0);
    program.set("least_distance", least_distance_);
}

}  // namespace lanthorn::gi
