#include "lanthorn/gi/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace lanthorn::gi {

namespace {

// Bounds on a scene's diffuse reflectance, over the materials in use: the largest, and whether any is above
// 0.
float largest_albedo(const FrameScene& scene) {
    float largest = 0;
    for (const Instance& instance : scene.instances) {
        const Material& m = scene.material(instance);
        if (m.unlit || m.alpha_mode == AlphaMode::blend) {  // blended surfaces take no part
            continue;
        }
        // Factors are all that a texture can reach: under one, some texel may be neither metal nor glass.
        const float metallic = m.metallic_roughness_texture.present() ? 0.0f : m.metallic;
        const float transmission = m.transmission_texture.present() ? 0.0f : m.transmission;
        const vec3 albedo = vec3(m.base_colour) * (1.0f - metallic) * (1.0f - transmission);
        largest = std::max({largest, albedo.x, albedo.y, albedo.z});
    }
    return std::min(largest, 1.0f);
}

bool any_emitter(const FrameScene& scene) {
    const bool punctual = std::ranges::any_of(scene.lights, [](const LightInstance& l) {
        return l.light.intensity > 0 && std::max({l.light.colour.x, l.light.colour.y, l.light.colour.z}) > 0;
    });
    return punctual || std::ranges::any_of(scene.instances, [&](const Instance& instance) {
               const Material& m = scene.material(instance);
               return m.emits() && m.alpha_mode != AlphaMode::blend;
           });
}

bool any_specular(const FrameScene& scene) {
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        const Material& m = scene.material(instance);
        return m.transmission > 0 || (m.metallic > 0.5f && m.roughness < 0.4f);
    });
}

float box_area(const Aabb& box) {
    const vec3 size = box.upper - box.lower;
    return box.empty() ? 0.0f : 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

// Whether a good part of the scene has come to lie where no candidate is: beyond a tenth of the diagonal of
// what the maps were chosen for, and a tenth of the bounding boxes' area.
bool outgrown(const FrameScene& scene, const Aabb& chosen_for) {
    if (scene.changes.arrived.empty() || chosen_for.empty()) {
        return false;
    }
    const vec3 margin(0.1f * chosen_for.diagonal());
    float beyond = 0;
    for (const std::uint32_t i : scene.changes.arrived) {
        const Aabb& box = scene.instances[i].bounds;
        const bool inside = glm::all(glm::greaterThanEqual(box.lower, chosen_for.lower - margin)) &&
                            glm::all(glm::lessThanEqual(box.upper, chosen_for.upper + margin));
        beyond += inside ? 0 : box_area(box);
    }
    float all = 0;
    for (const Instance& instance : scene.instances) {
        all += box_area(instance.bounds);
    }
    return beyond > 0.1f * all;
}

// The passes of gi.emc.final = gather, after those of the maps.
void plan_gather(GiPlan& plan, const FrameScene& scene, const GiSettings& s, const GiHistory& history) {
    constexpr int kFrames = 16;  // RememberedHits::kFrames
    const SceneChanges& changes = scene.changes;
    const bool sensors = !scene.sensors.empty();
    const bool surfaces = plan.draw_maps || plan.update_maps || !changes.painted.empty() || !history.has_lit;
    const bool light = surfaces || changes.lights || changes.emission;
    const bool view = !history.has_image || changes.camera || changes.relief;
    plan.list_texels = surfaces;
    plan.light_texels = light;
    plan.texel_rays = plan.bounces > 1 && (surfaces || history.texel_frames < kFrames);
    plan.list_points = surfaces || view;
    plan.point_rays = plan.list_points || history.point_frames < kFrames;
    plan.pass = 0;
    plan.trace = sensors && (light || !history.has_photons || history.fading);
    plan.gather = light || plan.texel_rays || plan.point_rays;

    const auto add = [&](std::string pass, bool on, std::string size, std::string why) {
        plan.entries.push_back({std::move(pass), on, std::move(size), std::move(why)});
    };
    const int texel_frames = surfaces ? 0 : history.texel_frames;
    const int point_frames = plan.list_points ? 0 : history.point_frames;
    const std::string no_photons = "gi.emc.final is gather: rays from the picture meet lit maps";
    for (const char* pass : {"emission", "bounces"}) {
        add(pass, plan.trace, plan.trace ? fmt::format("{} photons", s.photons) : "",
            plan.trace ? "light sensors count photons" : no_photons);
    }
    add("lit_maps", light || plan.texel_rays,
        light || plan.texel_rays ? fmt::format("{} bounces of {}", plan.bounces, s.bounces) : "",
        surfaces ? "the maps show other surfaces or colours: they are lit anew"
        : light  ? "a light has changed: what their rays have met is shaded again"
        : plan.texel_rays
            ? fmt::format("nothing moves: frame {} of {} of their rays", texel_frames + 1, kFrames)
            : "neither light nor geometry has changed: they hold");
    add("gather", plan.gather,
        plan.point_rays ? fmt::format("{} rays a point, one point {} x {} pixels", s.gather_rays,
                                      s.gather_grid, s.gather_grid)
                        : "",
        surfaces          ? "the maps show other surfaces or colours: no ray is remembered"
        : view            ? "another view: no ray is remembered"
        : plan.point_rays ? fmt::format("nothing moves: frame {} of {} of rays", point_frames + 1, kFrames)
        : plan.gather     ? "what is remembered is shaded again: no ray"
                          : "neither light nor view has changed: the image holds");
    add("filter", plan.gather, "", plan.gather ? "the gather is noisy" : "the image holds");
    add("splats", false, "", no_photons);
    add("accumulation", false, "", "gi.emc.final is gather: it remembers rays, not pictures");
    add("upsampling", plan.gather, "", plan.gather ? "from the grid of points" : "the image holds");
}

}  // namespace

bool GiPlan::on(const std::string& pass) const {
    return std::ranges::any_of(entries, [&](const PlanEntry& e) { return e.pass == pass && e.on; });
}

void GiPlan::give_up(const std::string& why) {
    bounces = 0;
    trace = gather = list_texels = light_texels = texel_rays = list_points = point_rays = false;
    for (PlanEntry& e : entries) {
        const bool needs_maps = e.pass == "emission" || e.pass == "bounces" || e.pass == "splats" ||
                                e.pass == "accumulation" || e.pass == "upsampling" || e.pass == "lit_maps" ||
                                e.pass == "gather" || e.pass == "filter";
        if (needs_maps) {
            e = {e.pass, false, "", why};
        }
    }
}

std::string no_indirect_light(const FrameScene& scene) {
    if (scene.instances.empty()) {
        return "the scene has no geometry: nothing reflects light";
    }
    if (!any_emitter(scene)) {
        return "the scene has no light: nothing to reflect";
    }
    if (largest_albedo(scene) <= 0) {
        return "no surface reflects diffusely: every photon would end at its first hit";
    }
    return {};
}

int useful_bounces(const FrameScene& scene, int limit) {
    // Below 1/500 light is under the image's own noise.
    constexpr float kNegligible = 1.0f / 500.0f;
    const float albedo = largest_albedo(scene);
    int bounces = 1;
    while (bounces < limit && std::pow(albedo, static_cast<float>(bounces + 1)) > kNegligible) {
        ++bounces;
    }
    return bounces;
}

int update_shares(const GiSettings& settings) {
    constexpr int kMost = 10;
    return std::min(settings.emc_update_interval, kMost);
}

GiPlan make_plan(const FrameScene& scene, const GiSettings& s, const GiHistory& history) {
    GiPlan plan;
    const auto add = [&](std::string pass, bool on, std::string size, std::string why) {
        plan.entries.push_back({std::move(pass), on, std::move(size), std::move(why)});
    };
    const auto all_off = [&](const std::string& why) {
        for (const char* pass :
             {"selection", "coverage", "progressive_update", "environment_maps", "emission", "bounces",
              "caustic_photons", "splats", "accumulation", "upsampling"}) {
            add(pass, false, "", why);
        }
        return plan;
    };
    if (s.technique == TechniqueKind::none) {
        return all_off("the technique is 'none': direct light alone");
    }
    if (s.technique == TechniqueKind::path) {
        return all_off("the technique is 'path': paths need no passes");
    }
    if (const std::string why = no_indirect_light(scene); !why.empty()) {
        return all_off(why);
    }
    const float albedo = largest_albedo(scene);
    plan.bounces = useful_bounces(scene, s.bounces);

    const SceneChanges& changes = scene.changes;
    const bool geometry = changes.geometry;
    const bool grown = outgrown(scene, history.chosen_for);
    plan.select_maps = !history.has_maps || changes.replaced || grown;
    plan.draw_maps = plan.select_maps || geometry || changes.pattern;
    const bool update = !plan.select_maps && (geometry || history.geometry_pending);
    const int update_in = std::max(s.emc_update_interval - 1 - history.round, 0);  // frames
    plan.shares = update_shares(s);
    plan.share = update && update_in < plan.shares ? plan.shares - 1 - update_in : -1;
    plan.update_maps = update && update_in == 0;
    const bool new_photons = !history.has_photons || plan.draw_maps || plan.update_maps || changes.lights ||
                             changes.emission || !changes.painted.empty() || history.fading;
    const bool new_image = new_photons || !history.has_image || changes.camera || changes.relief;
    const bool refine = !new_image && history.passes < s.accumulate;
    plan.pass = refine ? history.passes : 0;
    // A picture begins with the first photons: those of a later pass do not serve another view.
    plan.trace = new_photons || refine || (new_image && history.passes > 1);
    plan.gather = new_image || refine;

    add("selection", plan.select_maps,
        plan.select_maps
            ? fmt::format("{} candidates x 6 x 32^2, at most {} maps", s.emc_candidates, s.emc_count)
            : "",
        plan.select_maps
            ? (!history.has_maps ? "first frame: choose environment map centres by new coverage area"
               : changes.replaced
                   ? "nothing of the scene before is left: choose all maps anew"
                   : "what came reaches beyond the scene that maps were chosen for: choose anew")
            : "maps are chosen");
    const std::string no_update =
        plan.select_maps ? "all maps are chosen anew in this frame" : "geometry has not changed";
    add("coverage", plan.share >= 0,
        plan.share >= 0 ? fmt::format("share {} of {} of the candidates", plan.share + 1, plan.shares) : "",
        plan.share >= 0 ? "geometry has changed: candidates are seen anew, a share a frame"
        : update ? fmt::format("geometry changes, but candidates wait {} frames", update_in - plan.shares + 1)
                 : no_update);
    add("progressive_update", plan.update_maps, plan.update_maps ? "one exchange at most" : "",
        plan.update_maps ? "geometry has changed, and all candidates have been seen anew"
        : update         ? fmt::format("geometry has changed: to be decided in {} frames", update_in)
                         : no_update);
    add("environment_maps", plan.draw_maps,
        plan.draw_maps ? fmt::format("{} maps x 6 x {}^2", s.emc_count, s.emc_resolution) : "",
        plan.select_maps          ? "new centres"
        : geometry                ? "geometry has changed: faces that see what moves"
        : plan.draw_maps          ? "a material has another pattern: faces that see it; the centres hold"
        : changes.painted.empty() ? "geometry has not changed: the maps hold"
                                  : "a material has another colour, which maps look up: they hold");
    if (s.emc_final == EmcFinal::gather) {
        plan_gather(plan, scene, s, history);
        return plan;
    }
    add("emission", plan.trace, plan.trace ? fmt::format("{} photons", s.photons) : "",
        !history.has_photons ? "no photons yet"
        : refine ? fmt::format("nothing moves: pass {} of {} joins the mean", plan.pass + 1, s.accumulate)
        : new_photons ? (changes.lights             ? "a light has changed"
                         : changes.emission         ? "a material emits otherwise"
                         : !changes.painted.empty() ? "a material reflects otherwise"
                                                    : "what the maps see has changed")
        : plan.trace  ? "another view: the picture begins with the first photons"
                      : "neither light nor geometry has changed: the photons hold");
    add("bounces", plan.trace, fmt::format("{} of {}", plan.bounces, s.bounces),
        plan.bounces < s.bounces
            ? fmt::format("the brightest surface reflects {:.2f}: bounce {} cannot carry 1/500 of the light",
                          albedo, plan.bounces + 1)
            : "every bounce can still matter");
    add("caustic_photons", false, "",
        any_specular(scene) ? "specular surfaces are here, but caustics come with a later version"
                            : "no specular or transmissive surface");
    const int base = 1 << static_cast<int>(s.splat_base);
    add("splats", plan.gather, plan.gather ? fmt::format("1/{} of the size", base) : "",
        plan.trace    ? "new photons"
        : plan.gather ? (changes.camera ? "the camera has moved" : "a material has another normal map")
                      : "neither photons nor camera changed: the image holds");
    add("accumulation", refine, "",
        refine              ? "nothing moves: the mean of all passes so far is shown"
        : s.accumulate == 1 ? "gi.accumulate is 1: a still picture stays as it is"
        : plan.gather       ? "first pass of this picture"
                            : fmt::format("all {} passes are in the picture", s.accumulate));
    add("upsampling", plan.gather && base > 1, "",
        base > 1 ? "from the low resolution, discontinuities computed anew"
                 : "gi.splat.base is 1: full resolution");
    return plan;
}

std::string plan_table(const GiPlan& plan) {
    std::string text;
    for (const PlanEntry& e : plan.entries) {
        text += fmt::format("{:<20} {:<4} {:<40} {}\n", e.pass, e.on ? "on" : "off", e.size, e.why);
    }
    return text;
}

std::string plan_json(const GiPlan& plan) {
    nlohmann::json list = nlohmann::json::array();
    for (const PlanEntry& e : plan.entries) {
        list.push_back({{"pass", e.pass}, {"on", e.on}, {"size", e.size}, {"why", e.why}});
    }
    return list.dump();
}

}  // namespace lanthorn::gi
