#include "lanthorn/render/light_maps.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include "engine/render/area_samples.h"
#include "engine/render/lamp_tree.h"
#include "engine/render/shared_maps.h"
#include "lanthorn/core/colour.h"

namespace lanthorn::render {

namespace {

// Updates that a light keeps its place for before its faces get still layers.
constexpr int kSteadyAfter = 4;
constexpr std::size_t kMostStillBytes = std::size_t{256}
                                        << 20;  // of all still layers; faces beyond go without
// Layers that are drawn again in one update because something moved, where lamps share maps; a light's last
// face ends it.
constexpr int kMostLayersAgain = 192;
// Nothing is drawn nearer to a light than this share of the scene's diagonal or, in a large world, of so many
// metres. Much nearer, what is clipped there lies too far outside of the picture to be clipped exactly.
constexpr float kNear = 1e-5f;
constexpr float kLarge = 32;
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
int affordable_resolution(std::int64_t layers, int wanted) {
    constexpr std::int64_t kMostTexels = std::int64_t{1} << 25;
    constexpr int kCoarsest = 64;
    int resolution = wanted;
    while (resolution >= 2 * kCoarsest && layers * resolution * resolution > kMostTexels) {
        resolution /= 2;
    }
    return resolution;
}

std::int64_t layers_of(const std::vector<LightInstance>& lights) {
    std::int64_t layers = 0;
    for (const LightInstance& light : lights) {
        layers += needs_cube(light.light) ? 6 : 1;
    }
    return layers;
}

bool same_light(const LightData& a, const LightData& b) {
    // No padding: all members are four bytes wide.
    return std::memcmp(&a, &b, sizeof(LightData)) == 0;  // NOLINT(bugprone-suspicious-memory-comparison)
}

// Whether what a map shows is still right: it holds no brightness, and beyond the range it need not be right.
bool same_map(const LightData& before, LightData now) {
    if (now.range > before.range) {
        return false;
    }
    now.intensity = before.intensity;
    now.cone_scale = before.cone_scale;
    now.cone_offset = before.cone_offset;
    now.range = before.range;
    now.id = before.id;
    return same_light(before, now);
}

// Never shorter than the uniform block that lights.glsl may declare.
void write_lights(std::span<const LightData> lights, gpu::Buffer& buffer) {
    const std::size_t bytes = std::max<std::size_t>(lights.size(), kMaxUniformLights) * sizeof(LightData);
    if (buffer.bytes() != bytes) {
        buffer = gpu::Buffer(bytes);
    }
    buffer.write(0, lights);
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

LightMaps::LightMaps(std::uint64_t version)
    : program_("engine/render/light_map.vert", "engine/render/light_map.frag"),
      area_program_("engine/render/light_map.vert", "engine/render/light_map_area.frag"),
      version_(version) {}

void LightMaps::update(const FrameScene& scene, const GpuScene& gpu_scene, const EmissiveTriangles& emissive,
                       const RenderSettings& settings) {
    layers_drawn_ = 0;
    GLint most_layers = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most_layers);
    const std::int64_t wanted = layers_of(scene.lights);
    shares_maps_ = wanted > most_layers;
    const std::int64_t layers = shares_maps_ ? most_layers : wanted;
    const int resolution = affordable_resolution(layers, settings.shadow_resolution);
    std::vector<LightData> lights = describe_lights(scene, resolution, most_layers);
    punctual_count_ = static_cast<int>(lights.size());
    if (emissive.version() != emissive_version_ || settings != settings_) {
        AreaSamples samples = make_area_samples(emissive, settings);
        area_samples_ = std::move(samples.lights);
        if (!samples.nodes.empty()) {
            emitter_nodes_.hold(std::span<const vec4>(samples.nodes));
        }
        emissive_version_ = emissive.version();
        settings_ = settings;
    }
    lights.insert(lights.end(), area_samples_.begin(), area_samples_.end());
    const bool fresh = punctual_.allocate(resolution, static_cast<int>(layers));
    const bool fresh_area =
        area_.allocate(settings.area_lights_resolution, static_cast<int>(area_samples_.size()) * 6);

    const std::vector<LightData> before = std::exchange(lights_, std::move(lights));
    const bool altered =
        before.size() != lights_.size() || !light_buffer_ || !std::ranges::equal(before, lights_, same_light);
    if (altered) {
        write_lights(lights_, light_buffer_);
        shining_ = shining_lights(lights_);
        write_lights(shining_.lights, shining_buffer_);
    }
    if (altered || settings.lamps_error != lamps_error_) {
        lamps_error_ = settings.lamps_error;
        make_trees();
    }
    motion_.compare(scene);
    has_movers_.resize(lights_.size());
    steady_.resize(lights_.size());
    outdated_.resize(lights_.size());
    int as_before = 0;  // of the layers drawn
    waits_.resize(lights_.size());
    std::vector<std::size_t> due;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const bool fresh_map = lights_[i].type == kLightAreaSample ? fresh_area : fresh;
        const bool moved = i >= before.size() || !same_map(before[i], lights_[i]);
        const bool anew = motion_.restarted() || fresh_map || moved;
        if (lights_[i].shares_map != 0) {
            steady_[i] = waits_[i] = 0;
        } else if (lights_[i].intensity == vec3(0)) {
            steady_[i] = 0;
            if (anew || (motion_.changed() && !outdated_[i])) {
                leave_out(i);
            }
        } else if (anew || outdated_[i]) {
            steady_[i] = 0;
            draw_anew(i, scene, gpu_scene);
        } else if (!settings.shadow_kept) {
            draw_anew(i, scene, gpu_scene);
            as_before += motion_.changed() ? 0 : static_cast<int>(lights_[i].layers);
        } else {
            steady_[i] = std::min(steady_[i] + 1, kSteadyAfter);
            if (!shares_maps_) {
                follow(i, scene, gpu_scene);
            } else if (waits_[i] > 0 || sees_change(i)) {
                due.push_back(i);
            }
        }
    }
    follow_most_urgent(due, scene, gpu_scene);
    if (!motion_.any_moving()) {
        punctual_.forget_stills();
        area_.forget_stills();
    }
    glDisable(GL_DEPTH_TEST);
    if (altered || layers_drawn_ > as_before) {
        ++version_;
    }
}

std::vector<LightData> LightMaps::describe_lights(const FrameScene& scene, int resolution, int most) {
    std::vector<LightData> lights;
    std::uint32_t layers = 0;
    for (const LightInstance& instance : scene.lights) {
        LightData data = describe(instance, scene, resolution);
        data.first_layer = layers;
        layers += data.layers;
        lights.push_back(data);
    }
    if (!shares_maps_) {
        described_.clear();
        return lights;
    }
    if (std::ranges::equal(lights, described_, same_light)) {
        return {lights_.begin(), lights_.begin() + punctual_count_};
    }
    described_ = lights;
    share_maps(lights, lights_, static_cast<std::uint32_t>(most), resolution);
    return lights;
}

void LightMaps::make_trees() {
    shining_.nodes.clear();
    if (shining_.lights.size() > kMaxUniformLights && lamps_error_ > 0) {
        build_lamp_trees(shining_, lamps_error_);
    }
    const std::size_t bytes = shining_.nodes.size() * sizeof(vec4);
    if (nodes_buffer_.bytes() < bytes) {
        nodes_buffer_ = gpu::Buffer(bytes);
    }
    if (bytes > 0) {
        nodes_buffer_.write(0, std::span<const vec4>(shining_.nodes));
    }
}

void LightMaps::prepare(std::size_t index, const FrameScene& scene, const GpuScene& gpu_scene) {
    const LightData& light = lights_[index];
    const bool area = light.type == kLightAreaSample;
    SceneProgram& program = area ? area_program_ : program_;
    program.prepare(gpu_scene.variants());
    light_buffer_.bind_storage(kLightsBinding);
    const float length = std::min(scene.diagonal(), kLarge);
    const float near = kNear * (area ? std::min(std::sqrt(light.area), length) : length);
    program.set("light_index", static_cast<int>(index));
    program.set("near", near);
    program.set("light_position", light.position);
    program.set("light_direction", light.direction);
    program.set("directional", light.type == kLightDirectional ? 1 : 0);
    program.set("two_sided", static_cast<int>(light.two_sided));
    if (area) {
        program.set("light_middle", light.up);
        program.set("light_reach", 1.001f * light.depth_range);
    }
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void LightMaps::draw(const LightData& light, int face, const GpuScene& gpu_scene, Which which) {
    const Frustum frustum = face_frustum(light, face);
    const bool parallel = light.type == kLightDirectional;
    const TexelSize texel{light.position, parallel ? 0 : light.texel, parallel ? light.texel : 0};
    visible_.clear();
    for (const std::uint32_t i : gpu_scene.instances(DrawSet::all)) {
        const bool wanted = which == Which::all || (which == Which::moving && motion_.moving(i)) ||
                            (which == Which::still && !motion_.moving(i)) ||
                            (which == Which::rested && motion_.rested(i));
        if (wanted && frustum.touches(motion_.bounds(i))) {
            const std::uint32_t level = gpu_scene.level(i, texel);
            if (level != GpuScene::kTooSmall) {
                visible_.push_back({i, level});
            }
        }
    }
    gpu_scene.sort_near_first(visible_, light.position);
    SceneProgram& program = light.type == kLightAreaSample ? area_program_ : program_;
    program.set("face", face);
    gpu_scene.draw(program, visible_, Culling::none);
}

SceneMotion::Seen LightMaps::seen(const LightData& light, int face) const {
    const Frustum frustum = face_frustum(light, face);
    return motion_.seen([&](const Aabb& box) { return within_range(light, box) && frustum.touches(box); });
}

bool LightMaps::may_keep_another() const {
    return punctual_.still_bytes() + area_.still_bytes() < kMostStillBytes;
}

void LightMaps::leave_out(std::size_t index) {
    const LightData& light = lights_[index];
    LightMapArray& maps = light.type == kLightAreaSample ? area_ : punctual_;
    for (int face = 0; face < static_cast<int>(light.layers); ++face) {
        const int layer = static_cast<int>(light.first_layer) + face;
        maps.forget_still(layer);
        maps.begin(layer);
    }
    outdated_[index] = true;
}

void LightMaps::draw_anew(std::size_t index, const FrameScene& scene, const GpuScene& gpu_scene) {
    const LightData& light = lights_[index];
    LightMapArray& maps = light.type == kLightAreaSample ? area_ : punctual_;
    prepare(index, scene, gpu_scene);
    outdated_[index] = false;
    waits_[index] = 0;
    for (int face = 0; face < static_cast<int>(light.layers); ++face) {
        const int layer = static_cast<int>(light.first_layer) + face;
        maps.forget_still(layer);
        maps.begin(layer);
        draw(light, face, gpu_scene, Which::all);
        has_movers_[index][static_cast<std::size_t>(face)] = seen(light, face).moving;
        ++layers_drawn_;
    }
}

bool LightMaps::sees_change(std::size_t index) const {
    const LightData& light = lights_[index];
    for (int face = 0; face < static_cast<int>(light.layers); ++face) {
        const SceneMotion::Seen now = seen(light, face);
        if (now.left || now.rested || now.moving || now.painted ||
            has_movers_[index][static_cast<std::size_t>(face)]) {
            return true;
        }
    }
    return false;
}

void LightMaps::follow_most_urgent(std::vector<std::size_t>& due, const FrameScene& scene,
                                   const GpuScene& gpu_scene) {
    if (due.empty()) {
        return;
    }
    Aabb changed;
    motion_.seen([&](const Aabb& box) {
        changed.add(box);
        return false;
    });
    const auto urgency = [&](std::size_t i) {
        const LightData& light = lights_[i];
        const vec3 nearest = glm::clamp(light.position, changed.lower, changed.upper);
        const float apart = changed.empty() ? 1 : glm::distance(nearest, light.position) + 1e-3f;
        return luminance(light.intensity) / (apart * apart) * static_cast<float>(1 + waits_[i]);
    };
    std::vector<std::pair<float, std::size_t>> order;
    order.reserve(due.size());
    for (const std::size_t i : due) {
        order.emplace_back(-urgency(i), i);
    }
    std::ranges::sort(order);
    const int before = layers_drawn_;
    for (const auto& [minus_urgency, i] : order) {
        if (layers_drawn_ - before >= kMostLayersAgain) {
            ++waits_[i];
        } else if (waits_[i] > 0) {
            draw_anew(i, scene, gpu_scene);
        } else {
            follow(i, scene, gpu_scene);
        }
    }
}

void LightMaps::follow(std::size_t index, const FrameScene& scene, const GpuScene& gpu_scene) {
    const LightData& light = lights_[index];
    LightMapArray& maps = light.type == kLightAreaSample ? area_ : punctual_;
    bool prepared = false;
    for (int face = 0; face < static_cast<int>(light.layers); ++face) {
        const int layer = static_cast<int>(light.first_layer) + face;
        const SceneMotion::Seen now = seen(light, face);
        bool& has_movers = has_movers_[index][static_cast<std::size_t>(face)];
        const bool painted = now.painted && light.type != kLightAreaSample;  // those hold no colour
        const bool show = motion_.changed() && (now.left || now.moving || has_movers || painted);
        has_movers = now.moving;
        const bool kept = maps.has_still(layer);
        const bool layered =
            kept || (show && now.moving && steady_[index] == kSteadyAfter && may_keep_another());
        if (!show && !(kept && now.rested)) {
            continue;
        }
        if (!std::exchange(prepared, true)) {
            prepare(index, scene, gpu_scene);
        }
        if (layered && (!kept || now.left || painted)) {
            maps.begin_still(layer, true);
            draw(light, face, gpu_scene, Which::still);
        } else if (layered && now.rested) {
            maps.begin_still(layer, false);
            draw(light, face, gpu_scene, Which::rested);
        }
        if (!show) {
            continue;
        }
        if (layered) {
            maps.begin_over_still(layer);
        } else {
            maps.begin(layer);
        }
        draw(light, face, gpu_scene, layered ? Which::moving : Which::all);
        ++layers_drawn_;
    }
}

}  // namespace lanthorn::render
