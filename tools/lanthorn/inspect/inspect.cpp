// lanthorn inspect SCENE: what is in a scene, and with --plan what its light requires.
#include <fmt/format.h>

#include <memory>

#include "engine/core/json.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/render/render_settings.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/motion_tables.h"
#include "tools/lanthorn/common/plan_report.h"
#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/inspect/inspect_json.h"
#include "tools/lanthorn/inspect/scene_contents.h"
#include "tools/workbench/load/default_light.h"

namespace lanthorn::tools {

namespace {

struct InspectOptions {
    std::string scene;
    std::string variant;
    bool allow_outside = false;
    SettingsChoice settings;
    bool plan = false;
    bool json = false;
};

std::string vector_text(const dvec3& v) {
    return fmt::format("{:.3f} {:.3f} {:.3f}", v.x, v.y, v.z);
}

void print_section(const std::string& title, const TextTable& table) {
    if (!table.empty()) {
        fmt::print("\n{}\n{}", title, table.text());
    }
}

TextTable node_table(const SceneData& scene) {
    TextTable table({"#", "name", "parent", "shows", "extras"});
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const NodeData& node = scene.nodes[i];
        std::string shows;
        if (!node.meshes.empty()) {
            shows = fmt::format("mesh {}", fmt::join(node.meshes, ", "));
        }
        if (node.camera != kNone) {
            shows += fmt::format("{}camera {}", shows.empty() ? "" : ", ", node.camera);
        }
        if (node.light != kNone) {
            shows += fmt::format("{}light {}", shows.empty() ? "" : ", ", node.light);
        }
        table.add({fmt::format("{}", i), node.name,
                   node.parent == kNone ? "-" : fmt::format("{}", node.parent), shows.empty() ? "-" : shows,
                   node.extras});
    }
    return table;
}

TextTable mesh_table(const SceneData& scene) {
    TextTable table({"#", "name", "triangles", "vertices", "material", "size m", "deforms"});
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const Mesh& mesh = scene.meshes[i];
        table.add({fmt::format("{}", i), mesh.name, fmt::format("{}", mesh.indices.size() / 3),
                   fmt::format("{}", mesh.vertices.size()), scene.materials[mesh.material].name,
                   vector_text(mesh.bounds.size()), deformation_text(mesh)});
    }
    return table;
}

std::string material_notes(const Material& m) {
    std::string notes;
    const auto note = [&](bool applies, const std::string& text) {
        if (applies) {
            notes += (notes.empty() ? "" : ", ") + text;
        }
    };
    note(m.emits(), fmt::format("emits {} nits", vector_text(m.emissive)));
    note(m.alpha_mode == AlphaMode::mask, fmt::format("mask {:g}", m.alpha_cutoff));
    note(m.alpha_mode == AlphaMode::blend, "blend");
    note(m.double_sided, "double-sided");
    note(m.unlit, "unlit");
    note(m.transmission > 0, fmt::format("transmission {:g}", m.transmission));
    note(m.bounds_volume(), "bounds a volume");
    note(m.specular != 1, fmt::format("specular {:g}", m.specular));
    note(m.ior != 1.5f, fmt::format("ior {:g}", m.ior));
    for (const auto& [texture, name] : named_textures(m)) {
        note(texture->present(), fmt::format("{} texture {}", name, texture->texture));
    }
    return notes;
}

TextTable material_table(const SceneData& scene) {
    TextTable table({"#", "name", "base colour", "metallic", "roughness", "notes"});
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& m = scene.materials[i];
        table.add({fmt::format("{}", i), m.name, vector_text(vec3(m.base_colour)),
                   fmt::format("{:g}", m.metallic), fmt::format("{:g}", m.roughness), material_notes(m)});
    }
    return table;
}

TextTable texture_table(const SceneData& scene) {
    TextTable table({"#", "image", "name", "size"});
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const std::uint32_t image = scene.textures[i].image;
        table.add({fmt::format("{}", i), fmt::format("{}", image), scene.images[image].name,
                   fmt::format("{} x {}", scene.images[image].width, scene.images[image].height)});
    }
    return table;
}

TextTable light_table(const SceneData& scene, const std::vector<dmat4>& world) {
    TextTable table({"node", "name", "type", "intensity", "colour", "position m", "cone"});
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].light == kNone) {
            continue;
        }
        const Light& light = scene.lights[scene.nodes[i].light];
        table.add(
            {fmt::format("{}", i), scene.nodes[i].name, light_type_name(light.type),
             fmt::format("{:g} {}", light.intensity, light.type == LightType::directional ? "lx" : "cd"),
             vector_text(light.colour), vector_text(dvec3(world[i][3])),
             light.type == LightType::spot
                 ? fmt::format("{:.1f} to {:.1f} deg", glm::degrees(light.inner_cone),
                               glm::degrees(light.outer_cone))
                 : "-"});
    }
    return table;
}

TextTable camera_table(const SceneData& scene, const std::vector<dmat4>& world) {
    TextTable table({"node", "name", "projection", "near m", "far m", "position m"});
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].camera == kNone) {
            continue;
        }
        const Camera& camera = scene.cameras[scene.nodes[i].camera];
        table.add({fmt::format("{}", i), scene.nodes[i].name,
                   camera.orthographic
                       ? fmt::format("orthographic {:g} x {:g} m", 2 * camera.x_mag, 2 * camera.y_mag)
                       : fmt::format("perspective {:.1f} deg", glm::degrees(camera.y_fov)),
                   fmt::format("{:g}", camera.z_near),
                   camera.z_far > 0 ? fmt::format("{:g}", camera.z_far) : "infinite",
                   vector_text(dvec3(world[i][3]))});
    }
    return table;
}

void print_contents(const SceneData& scene) {
    const std::vector<dmat4> world = world_matrices(scene);
    const WorldBox box = world_bounds(scene, world);
    fmt::print("{}\n", scene.source);
    TextTable summary(
        {"nodes", "meshes", "triangles", "placed", "materials", "textures", "lights", "cameras"});
    summary.add({fmt::format("{}", scene.nodes.size()), fmt::format("{}", scene.meshes.size()),
                 fmt::format("{}", scene.triangle_count()), fmt::format("{}", placed_triangles(scene)),
                 fmt::format("{}", scene.materials.size()), fmt::format("{}", scene.textures.size()),
                 fmt::format("{}", scene.lights.size()), fmt::format("{}", scene.cameras.size())});
    fmt::print("{}", summary.text());
    if (!box.empty()) {
        fmt::print("\nbounds\n  from {} to {} m, diagonal {:.3f} m\n", vector_text(box.lower),
                   vector_text(box.upper), glm::length(box.upper - box.lower));
    }
    print_section("nodes", node_table(scene));
    print_section("meshes", mesh_table(scene));
    print_section("skins", skin_table(scene));
    print_section("animations", animation_table(scene));
    print_section("materials", material_table(scene));
    print_section("textures", texture_table(scene));
    print_section("lights", light_table(scene, world));
    print_section("cameras", camera_table(scene, world));
    if (!scene.warnings.empty()) {
        fmt::print("\nwarnings\n");
        for (const std::string& warning : scene.warnings) {
            fmt::print("  {}\n", warning);
        }
    }
}

// Of the scene as render shows it; the note says what render adds to it.
struct Plan {
    gi::GiPlan plan;
    std::optional<std::string> note;
};

// What settings alone switch on.
void add_picture_passes(gi::GiPlan& plan, const SceneData& scene, const render::RenderSettings& settings) {
    const auto add = [&](const char* pass, bool on, std::string size, std::string why) {
        plan.entries.push_back({pass, on, on ? std::move(size) : std::string(), std::move(why)});
    };
    const bool air = settings.air_scattering > 0 && !scene.lights.empty();
    add("air", air, fmt::format("a sixteenth of the pixels x {} x lamps", settings.air_steps),
        settings.air_scattering > 0
            ? scene.lights.empty() ? "no lamp shines on it" : "render.air.scattering is more than 0"
            : "render.air.scattering is 0");
    add("bloom", settings.bloom_share > 0, "a sixteenth of the pixels, and a third more",
        settings.bloom_share > 0 ? "render.bloom.share is more than 0" : "render.bloom.share is 0");
}

Plan plan_of(SceneData scene, const SettingsChoice& choice) {
    const ChosenSettings chosen(choice);
    Plan result;
    result.note = add_default_light(scene, "");
    result.plan = first_plan(scene, chosen.settings);
    add_picture_passes(result.plan, scene, render::render_settings(chosen.settings));
    return result;
}

void print_json(const SceneData& scene, const InspectOptions& options) {
    nlohmann::ordered_json json = contents_json(scene);
    if (options.plan) {
        const Plan made = plan_of(scene, options.settings);
        json["plan"] = parse_ordered_json(gi::plan_json(made.plan), "own JSON");
        json["plan_note"] = made.note ? nlohmann::ordered_json(*made.note) : nlohmann::ordered_json(nullptr);
    }
    fmt::print("{}\n", json.dump(2));
}

ExitCode inspect(const InspectOptions& options) {
    const SceneData scene =
        import_gltf(options.scene, {.variant = options.variant, .allow_outside = options.allow_outside});
    if (options.json) {
        print_json(scene, options);
        return ExitCode::ok;
    }
    print_contents(scene);
    if (options.plan) {
        const Plan made = plan_of(scene, options.settings);
        fmt::print("\nplan{}\n{}", made.note ? " of the scene as render shows it: " + *made.note : "",
                   gi::plan_table(made.plan));
    }
    return ExitCode::ok;
}

}  // namespace

Command add_inspect(CLI::App& app) {
    auto options = std::make_shared<InspectOptions>();
    CLI::App* command =
        app.add_subcommand("inspect", "What is in a scene; what its light requires, and why.");
    add_scene_option(*command, options->scene)->required();
    command->add_flag("--json", options->json, "print one JSON object instead of tables (docs/inspect.md)");
    command->add_flag("--plan", options->plan, "print the passes that its first frame needs, and why");
    add_file_options(*command, options->variant, options->allow_outside);
    add_settings_options(*command, options->settings);
    return [options] { return inspect(*options); };
}

}  // namespace lanthorn::tools
