#include "tools/workbench/load/default_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtx/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/core/json.h"
#include "engine/scene/kept_emissive_pieces.h"
#include "gi_module/reference/material_table.h"
#include "gi_module/reference/sampling.h"
#include "gi_module/reference/trace_scene.h"
#include "lanthorn/assets/sky_file.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn::workbench {

namespace {

constexpr float kDefaultIlluminance = 1000;  // lux: a bright room; exposure follows anyway
constexpr float kShoulder = 0.35f;           // of the distance to what is looked at, upwards and to the left
constexpr float kBeforeWall = 0.8f;          // of the way to a surface that is nearer
constexpr int kLooks = 64;                   // directions in which the open sky is looked for
constexpr float kOpen = 0.25f;               // share of them that must escape
constexpr double kFaint = 0.1;               // lux: less than half a full moon's

// Whether somebody has put a light or a sky there.
bool is_lit_on_purpose(const SceneData& scene) {
    return std::ranges::any_of(scene.nodes,
                               [](const NodeData& node) { return node.light != kNone || node.sky != kNone; });
}

// Says what sky it stands in, if it is a sun (ClearSky).
bool has_sky_of_its_own(const NodeData& node) {
    return !node.extras.empty() && parse_json(node.extras, "extras").contains("clear_sky");
}

// Whether all that shines is suns without a sky.
bool has_suns_alone(const SceneData& scene) {
    bool any = false, others = false;
    for (const NodeData& node : scene.nodes) {
        const bool sun = node.light != kNone && scene.lights[node.light].type == LightType::directional;
        any = any || sun;
        others =
            others || node.sky != kNone || (node.light != kNone && !sun) || (sun && has_sky_of_its_own(node));
    }
    return any && !others;
}

bool glows(const SceneData& scene) {
    return std::ranges::any_of(scene.nodes, [&](const NodeData& node) {
        return std::ranges::any_of(node.meshes, [&](std::uint32_t mesh) {
            return scene.materials[scene.meshes[mesh].material].emits();
        });
    });
}

// Whether some surfaces shine no brighter than glTF's emissiveFactor alone can say, and others do not shine:
// colours that their maker wanted to be seen, not lamps.
bool shines_as_colour_alone(const SceneData& scene) {
    constexpr float kFactorAlone = 1;  // nit
    float brightest = 0;
    bool some_dark = false;
    for (const NodeData& node : scene.nodes) {
        for (const std::uint32_t mesh : node.meshes) {
            const Material& material = scene.materials[scene.meshes[mesh].material];
            const vec3& nits = material.emissive;
            brightest = std::max({brightest, nits.x, nits.y, nits.z});
            some_dark = some_dark || !material.emits();
        }
    }
    return some_dark && brightest <= kFactorAlone;
}

double area_of(const Mesh& mesh, const mat4& transform) {
    double area = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto at = [&](std::size_t c) {
            return dvec3(mat3(transform) * mesh.vertices[mesh.indices[i + c]].position);
        };
        area += glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
    }
    return area;
}

void add_light(SceneData& scene, const std::string& name, const Light& light, const dvec3& at,
               const vec3& shines) {
    NodeData node;
    node.name = name;
    node.light = static_cast<std::uint32_t>(scene.lights.size());
    node.local.translation = at;
    node.local.rotation = glm::rotation(vec3(0, 0, -1), shines);
    scene.lights.push_back(light);
    scene.nodes.push_back(std::move(node));
}

void add_sky(SceneData& scene, const std::string& name, Sky sky) {
    NodeData node;
    node.name = name;
    node.sky = static_cast<std::uint32_t>(scene.skies.size());
    scene.skies.push_back(std::move(sky));
    scene.nodes.push_back(std::move(node));
}

// What the camera of a frame has around it.
class Surroundings {
  public:
    explicit Surroundings(const FrameScene& frame)
        : frame_(frame), materials_(*frame.assets), scene_(frame, materials_, reference::Structure::moving) {}

    // Metres to the first surface, at most `farthest` lengths of `direction`.
    float first_surface(const vec3& direction, float farthest) const {
        reference::SurfaceHit hit;
        return scene_.intersect(frame_.camera.position, direction, 0, farthest, reference::Blended::ignored,
                                hit)
                   ? hit.t
                   : farthest;
    }
    // Lux, if all that surfaces emit fell evenly on the box around the scene.
    double glow() const {
        double flux = 0;  // lumen
        KeptEmissivePieces kept;
        for (const Instance& instance : frame_.instances) {
            const Mesh& mesh = frame_.assets->meshes[instance.mesh];
            const reference::MaterialConstants& material = materials_[mesh.material];
            if (material.emits) {
                const double sides = material.double_sided ? 2 : 1;
                const auto pieces = kept.of(*frame_.assets, instance.mesh);
                const vec3 share = pieces ? mean_share(mesh, instance.transform, *pieces) : vec3(1);
                flux += sides * kPi * luminance(dvec3(material.emitted * share)) *
                        area_of(mesh, instance.transform);
            }
        }
        const dvec3 size(frame_.bounds.size());
        return flux / std::max(2 * (size.x * size.y + size.y * size.z + size.z * size.x), 1e-30);
    }
    // Whether the camera stands under the open sky: of the directions upwards, evenly by projected area, a
    // good part meets nothing.
    bool open() const {
        const float reach = 2 * frame_.diagonal();
        int escaped = 0;
        for (int i = 0; i < kLooks; ++i) {
            const vec2 u((static_cast<float>(i) + 0.5f) / kLooks,
                         std::fmod(static_cast<float>(i) * 0.618034f, 1.0f));
            escaped += first_surface(reference::cosine_direction(vec3(0, 1, 0), u), reach) < reach ? 0 : 1;
        }
        return static_cast<float>(escaped) >= kOpen * kLooks;
    }

  private:
    const FrameScene& frame_;
    reference::MaterialTable materials_;
    reference::TraceScene scene_;
};

void add_shoulder_light(SceneData& scene, const FrameScene& frame, const Surroundings& around) {
    const CameraView& view = frame.camera;
    const mat3 to_render = glm::transpose(mat3(view.view));
    const float diagonal = frame.diagonal();
    const vec3 target = view.position - to_render[2] * around.first_surface(-to_render[2], diagonal);
    const float reach = std::max(glm::length(target - view.position), 0.01f * diagonal);
    const vec3 aside = kShoulder * reach * (to_render[1] - to_render[0]);
    const float room = around.first_surface(aside, 1);
    const vec3 position = view.position + aside * (room < 1 ? kBeforeWall * room : 1.0f);
    const float distance = std::max(glm::length(target - position), 0.01f * diagonal);
    Light light;
    light.intensity = kDefaultIlluminance * distance * distance;
    add_light(scene, "default light", light, frame.origin + dvec3(position), vec3(0, 0, -1));
}

// In the afternoon, behind the camera's left shoulder.
vec3 shoulder_sun(const CameraView& view) {
    const mat3 to_render = glm::transpose(mat3(view.view));
    const auto level = [](vec3 v) { return vec3(v.x, 0, v.z); };
    return glm::normalize(vec3(0, 1, 0) + 0.6f * level(to_render[2]) - 0.7f * level(to_render[0]));
}

// The clear day's sky about the brightest sun, as bright beside it as that day's is beside its own. Whether
// there is one: a sun above the horizon that shines.
bool add_sky_of_sun(SceneData& scene, const FrameScene& frame) {
    const auto lux = [](const LightInstance& sun) {
        return luminance(dvec3(sun.light.colour)) * static_cast<double>(sun.light.intensity);
    };
    const auto sun = std::ranges::max_element(frame.lights, {}, lux);
    if (sun == frame.lights.end() || !(lux(*sun) > 0) || !(sun->direction.y < 0)) {
        return false;
    }
    const vec3 to_sun = -sun->direction;
    const Light of_that_day = clear_sun(to_sun);
    Sky sky;
    sky.image = std::make_shared<const SkyImage>(clear_sky(to_sun));
    sky.intensity = static_cast<float>(
        lux(*sun) / (luminance(dvec3(of_that_day.colour)) * static_cast<double>(of_that_day.intensity)));
    add_sky(scene, "sky of the sun", std::move(sky));
    return true;
}

}  // namespace

void add_environment(SceneData& scene, const std::string& file, float intensity) {
    std::vector<SkySun> suns;
    std::string note;
    Sky sky = read_sky(file, suns, &note);
    if (!note.empty()) {
        scene.warnings.push_back(std::move(note));
    }
    sky.intensity = intensity;
    // It takes the place of the file's own, with its suns.
    for (NodeData& own : scene.nodes) {
        if (own.parent < scene.nodes.size() && scene.nodes[own.parent].sky < scene.skies.size()) {
            own.light = kNone;
        }
    }
    for (NodeData& own : scene.nodes) {
        own.sky = kNone;
    }
    NodeData node;
    node.name = sky.image->name;
    add_sky_nodes(scene, std::move(node), std::move(sky), suns);
}

std::optional<std::string> add_default_light(SceneData& scene, const std::string& camera) {
    const bool has_glow = glows(scene);
    const bool suns_alone = has_suns_alone(scene) && !has_glow;
    if (is_lit_on_purpose(scene) && !suns_alone) {
        return std::nullopt;
    }
    ecs::World world;
    const std::uint32_t eye = find_camera(scene, camera);
    const std::vector<ecs::Entity> entities = spawn(world, scene);
    const FrameScene frame = still_scene(world, eye == kNone ? ecs::kNullEntity : entities[eye]);
    if (frame.instances.empty()) {
        return std::nullopt;
    }
    const Surroundings around(frame);
    if (suns_alone) {
        if (!around.open() || !add_sky_of_sun(scene, frame)) {
            return std::nullopt;
        }
        return "found a sun and no sky; the sky of a clear day is added to match it (--no-default-light: "
               "none)";
    }
    // A lamp in a room lights it, however faint: the exposure follows. Under the open sky nothing comes back.
    const bool is_enough =
        has_glow && (!around.open() || (around.glow() >= kFaint && !shines_as_colour_alone(scene)));
    if (is_enough) {
        return std::nullopt;
    }
    if (!around.open()) {
        add_shoulder_light(scene, frame, around);
        return "found no light; one over the camera's shoulder is added (--no-default-light: none)";
    }
    const vec3 to_sun = shoulder_sun(frame.camera);
    Sky sky;
    sky.image = std::make_shared<const SkyImage>(clear_sky(to_sun));
    add_sky(scene, "clear sky", std::move(sky));
    add_light(scene, "sun", clear_sun(to_sun), frame.origin, -to_sun);
    return has_glow
               ? "found no light but surfaces that shine faintly or as colours; the sky and the sun of a "
                 "clear day "
                 "are added (--no-default-light: none)"
               : "found no light; the sky and the sun of a clear day are added (--no-default-light: none)";
}

}  // namespace lanthorn::workbench
