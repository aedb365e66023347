#include "engine/render/light_maps.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include "engine/render/area_samples.h"

namespace lanthorn::render {

namespace {

constexpr float kWidestFrustum = kPi / 3;  // outer cone of a spot that one square frustum still holds well

bool needs_cube(const Light& light) {
    return light.type == LightType::point ||
           (light.type == LightType::spot && light.outer_cone > kWidestFrustum);
}

// Axes of a light's map: right x up = -direction.
void set_axes(LightData& data) {
    const vec3 d = data.direction;
    const vec3 helper = std::abs(d.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
    data.right = glm::normalize(glm::cross(d, helper));
    data.up = glm::cross(data.right, d);
}

LightData describe(const LightInstance& instance, const FrameScene& scene, int resolution) {
    const Light& light = instance.light;
    LightData data{};
    data.position = instance.position;
    data.direction = instance.direction;
    data.range = std::min(light.range, 1e30f);
    data.intensity = light.colour * light.intensity;
    data.cos_outer = -1;
    data.layers = 6;
    data.extent = 1;
    data.id = instance.id;
    set_axes(data);
    switch (light.type) {
        case LightType::point:
            data.type = kLightPoint;
            break;
        case LightType::spot:
            data.type = kLightSpot;
            data.cos_outer = std::cos(light.outer_cone);
            data.cone_scale = 1 / std::max(1e-3f, std::cos(light.inner_cone) - data.cos_outer);
            data.cone_offset = -data.cos_outer * data.cone_scale;
            if (!needs_cube(light)) {
                data.layers = 1;
                // Four texels of margin, so that filtering at the cone's edge stays inside.
                data.extent = std::tan(light.outer_cone) / (1 - 8.0f / static_cast<float>(resolution));
            }
            break;
        case LightType::directional: {
            data.type = kLightDirectional;
            data.layers = 1;
            const float radius = 0.51f * scene.diagonal();
            data.position = scene.bounds.centre() - instance.direction * radius;
            data.extent = radius / (1 - 8.0f / static_cast<float>(resolution));
            data.depth_range = 2 * radius;
            break;
        }
    }
    data.texel = 2 * data.extent / static_cast<float>(resolution);
    return data;
}

// `wanted`, halved until the maps of all lights together keep within bounds (12 bytes a texel).
int affordable_resolution(const std::vector<LightInstance>& lights, int wanted) {
    constexpr std::int64_t kMostTexels = std::int64_t{1} << 25;
    constexpr int kCoarsest = 64;
    std::int64_t layers = 0;
    for (const LightInstance& light : lights) {
        layers += needs_cube(light.light) ? 6 : 1;
    }
    int resolution = wanted;
    while (resolution >= 2 * kCoarsest && layers * resolution * resolution > kMostTexels) {
        resolution /= 2;
    }
    return resolution;
}

bool same(const LightData& a, const LightData& b) {
    return std::memcmp(&a, &b, sizeof(LightData)) == 0;
}

// Whether only brightness differs, which a map does not hold.
bool same_map(const LightData& a, LightData b) {
    b.intensity = a.intensity;
    b.cone_scale = a.cone_scale;
    b.cone_offset = a.cone_offset;
    b.range = a.range;
    b.id = a.id;
    return same(a, b);
}

Frustum face_frustum(const LightData& light, int face) {
    Frustum frustum(light.position);
    if (light.layers == 6) {
        frustum = Frustum::of_cube_face(light.position, face);
    } else {
        const bool parallel = light.type == kLightDirectional;
        for (const vec3& axis : {light.right, light.up, -light.right, -light.up}) {
            frustum.cut(parallel ? axis : axis + light.direction * light.extent, parallel ? light.extent : 0);
        }
    }
    if (light.type == kLightAreaSample && light.two_sided == 0) {
        frustum.cut(light.direction);
    }
    return frustum;
}

bool within_range(const LightData& light, const Aabb& box) {
    if (light.type == kLightDirectional || light.range >= 1e30f) {
        return true;
    }
    const vec3 nearest = glm::clamp(light.position, box.lower, box.upper);
    return glm::distance(nearest, light.position) <= light.range;
}

}  // namespace

LightMaps::LightMaps()
    : program_("engine/render/light_map.vert", "engine/render/light_map.frag"),
      area_program_("engine/render/light_map.vert", "engine/render/light_map_area.frag") {}

bool LightMaps::Maps::allocate(int new_resolution, int new_layers, bool with_albedo) {
    if (new_resolution == resolution && new_layers == layers) {
        return false;
    }
    resolution = new_resolution;
    layers = new_layers;
    const ivec2 size(resolution);
    const int allocated = std::max(layers, 1);
    framebuffers.clear();
    distance = gpu::Texture::make_2d_array(GL_R32F, size, allocated);
    depth = gpu::Texture::make_2d(GL_DEPTH_COMPONENT32F, size);
    normals = gpu::Texture::make_2d_array(GL_RG16_SNORM, size, allocated);
    if (with_albedo) {
        albedo = gpu::Texture::make_2d_array(GL_RGBA16F, size, allocated);
    }
    for (int layer = 0; layer < layers; ++layer) {
        if (with_albedo) {
            framebuffers.push_back(gpu::Framebuffer({&distance, &normals, &albedo}, &depth, layer));
        } else {
            framebuffers.push_back(gpu::Framebuffer({&distance, &normals}, &depth, layer));
        }
    }
    return true;
}

void LightMaps::update(const FrameScene& scene, const GpuScene& gpu_scene, const EmissiveTriangles& emissive,
                       const RenderSettings& settings) {
    layers_drawn_ = 0;
    std::vector<LightData> lights;
    const int resolution = affordable_resolution(scene.lights, settings.shadow_resolution);
    GLint most_layers = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most_layers);
    std::uint32_t layers = 0;
    for (const LightInstance& instance : scene.lights) {
        LightData data = describe(instance, scene, resolution);
        data.first_layer = layers;
        if (layers + data.layers > static_cast<std::uint32_t>(most_layers)) {
            data.layers = 0;
        }
        layers += data.layers;
        lights.push_back(data);
    }
    punctual_count_ = static_cast<int>(lights.size());
    if (emissive.version() != emissive_version_ || settings != settings_) {
        area_samples_ = make_area_samples(emissive, settings);
        emissive_version_ = emissive.version();
        settings_ = settings;
    }
    lights.insert(lights.end(), area_samples_.begin(), area_samples_.end());
    const bool fresh = punctual_.allocate(resolution, static_cast<int>(layers), true);
    const bool fresh_area =
        area_.allocate(settings.area_lights_resolution, static_cast<int>(area_samples_.size()) * 6, false);

    const std::vector<LightData> before = std::exchange(lights_, std::move(lights));
    const bool altered =
        before.size() != lights_.size() || !light_buffer_ || !std::ranges::equal(before, lights_, same);
    if (altered) {
        // Never shorter than the uniform block that lights.glsl may declare.
        const std::size_t count = std::max<std::size_t>(lights_.size(), kMaxUniformLights);
        if (light_buffer_.bytes() != count * sizeof(LightData)) {
            light_buffer_ = gpu::Buffer(count * sizeof(LightData));
        }
        light_buffer_.write(0, std::span<const LightData>(lights_));
    }
    const bool skipped = scene.frame != last_frame_ && scene.frame != last_frame_ + 1;
    last_frame_ = scene.frame;
    const bool all = scene.changes.assets || skipped;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const bool area = lights_[i].type == kLightAreaSample;
        const bool moved = i >= before.size() || !same_map(before[i], lights_[i]);
        const bool geometry = scene.changes.geometry &&
                              (scene.changes.dirty.empty() || within_range(lights_[i], scene.changes.dirty));
        if (all || moved || (area ? fresh_area : fresh)) {
            draw_light(i, scene, gpu_scene, nullptr);
        } else if (geometry) {
            draw_light(i, scene, gpu_scene, scene.changes.dirty.empty() ? nullptr : &scene.changes.dirty);
        }
    }
    if (altered || layers_drawn_ > 0) {
        ++version_;
    }
}

void LightMaps::draw_light(std::size_t index, const FrameScene& scene, const GpuScene& gpu_scene,
                           const Aabb* dirty) {
    const LightData& light = lights_[index];
    const bool area = light.type == kLightAreaSample;
    const Maps& maps = area ? area_ : punctual_;
    SceneProgram& program = area ? area_program_ : program_;
    program.prepare(gpu_scene.variants());
    light_buffer_.bind_storage(kLightsBinding);
    // Nearer than this to the light nothing is drawn; reversed depth keeps its precision whatever it is.
    const float near = 1e-5f * (area ? std::min(std::sqrt(light.area), scene.diagonal()) : scene.diagonal());
    program.set("light_index", static_cast<int>(index));
    program.set("near", near);
    program.set("light_position", light.position);
    program.set("light_direction", light.direction);
    program.set("directional", light.type == kLightDirectional ? 1 : 0);
    program.set("two_sided", static_cast<int>(light.two_sided));
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_FRAMEBUFFER_SRGB);
    for (std::uint32_t face = 0; face < light.layers; ++face) {
        const Frustum frustum = face_frustum(light, static_cast<int>(face));
        if (dirty != nullptr && !frustum.touches(*dirty)) {
            continue;
        }
        const gpu::Framebuffer& target = maps.framebuffers[light.first_layer + face];
        target.bind(ivec2(maps.resolution));
        const vec4 zero(0);
        for (GLint i = 0; i < (area ? 2 : 3); ++i) {
            glClearNamedFramebufferfv(target.id(), GL_COLOR, i, &zero.x);
        }
        glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &zero.x);
        gpu_scene.find_visible(DrawSet::opaque_and_mask, frustum, visible_);
        program.set("face", static_cast<int>(face));
        gpu_scene.draw(program, visible_, 1, Culling::none);
        ++layers_drawn_;
    }
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_DEPTH_TEST);
}

std::string LightMaps::reload_if_changed() {
    return program_.reload_if_changed() + area_program_.reload_if_changed();
}

}  // namespace lanthorn::render
