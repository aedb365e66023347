#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/ecs/component_json.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"
#include "tools/editor/window/component_rows.h"
#include "tools/editor/window/lines.h"
#include "tools/editor/window/panels.h"

namespace lanthorn::edit_window {

using editor::EditModel;
using editor::ModelNode;

namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

bool heading(const char* words, bool open = true) {
    return ImGui::CollapsingHeader(words, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

std::string whom(const EditorState& state) {
    return state.chosen.size() == 1 ? editor::called(state.session.model(), state.chosen.front())
                                    : fmt::format("{} things", state.chosen.size());
}

const char* kind_of(const ModelNode& node) {
    return node.light != kNone    ? "light"
           : node.camera != kNone ? "camera"
           : node.mesh != kNone   ? "shape"
                                  : "node";
}

void transform_rows(EditorState& state) {
    const EditModel& model = state.session.model();
    const ModelNode& first = model.node(state.chosen.front());
    const auto differ = [&](auto get) {
        return std::ranges::any_of(state.chosen,
                                   [&](std::uint32_t n) { return get(model.node(n)) != get(first); });
    };
    // One number of all that are chosen.
    const auto all = [&](auto change) {
        std::vector<std::string> lines;
        for (const std::uint32_t n : state.chosen) {
            const ModelNode& node = model.node(n);
            Transform to = node.local;
            change(to);
            for (std::string& line : transform_lines(state.session.path_of(n), node.local, to)) {
                lines.push_back(std::move(line));
            }
        }
        return lines;
    };
    int which = -1;
    NumberChange change = state.fields.vector("place", first.local.translation, "m", 0.01,
                                              differ([](const ModelNode& n) { return n.local.translation; }),
                                              "metres from its parent", which);
    if (which >= 0) {
        state.follow(change.doing, "move " + whom(state),
                     all([&](Transform& t) { t.translation[which] = change.value; }));
    }
    // Quaternions of floats hold about as much.
    const auto angles_of = [](const quat& r) {
        return glm::round(1e4 * kDegrees * dvec3(glm::eulerAngles(glm::dquat(r)))) / 1e4;
    };
    const dvec3 angles = angles_of(first.local.rotation);
    change = state.fields.vector("turn", angles, "\u00b0", 0.5,
                                 differ([](const ModelNode& n) { return n.local.rotation; }),
                                 "degrees about X, then Y, then Z", which);
    if (which >= 0) {
        state.follow(change.doing, "turn " + whom(state), all([&](Transform& t) {
                         dvec3 to = angles_of(t.rotation);
                         to[which] = change.value;
                         t.rotation = quat(glm::dquat(to / kDegrees));
                     }));
    }
    change = state.fields.vector("size", dvec3(first.local.scale), "", 0.01,
                                 differ([](const ModelNode& n) { return n.local.scale; }),
                                 "along its own axes", which);
    if (which >= 0) {
        state.follow(change.doing, "scale " + whom(state),
                     all([&](Transform& t) { t.scale[which] = static_cast<float>(change.value); }));
    }
}

void material_rows(EditorState& state, std::uint32_t index) {
    const EditModel& model = state.session.model();
    const Material& material = *model.materials[index];
    const std::string name = editor::material_name(model, index);
    ImGui::PushID(static_cast<int>(index));
    const auto line = [&](std::string_view field, const std::string& value) {
        return std::vector<std::string>{
            fmt::format("set-material {} {} {}", editor::word(name), field, editor::word(value))};
    };
    const std::string of = " of " + name;
    ImGui::TextDisabled("  %s%s", name.empty() ? "material" : name.c_str(),
                        material.base_colour_texture.present() ? "   (textured)" : "");
    vec3 colour(material.base_colour);
    Doing doing = state.fields.colour("colour", colour, "a factor of the texture where there is one");
    state.follow(
        doing, "colour" + of,
        line("base_colour", fmt::format("[{},{},{},{}]", editor::number(colour.x), editor::number(colour.y),
                                        editor::number(colour.z), editor::number(material.base_colour.w))));
    const auto number = [&](const char* label, const char* field, double value, double upper,
                            const char* words) {
        NumberRow row{.label = label, .value = value};
        row.lower = 0;
        row.upper = upper;
        row.step = 0.004;
        row.words = words;
        const NumberChange change = state.fields.number(row);
        state.follow(change.doing, label + of, line(field, json_number(change.value)));
    };
    number("roughness", "roughness", static_cast<double>(material.roughness), 1, "0 mirrors, 1 is chalk");
    number("metallic", "metallic", static_cast<double>(material.metallic), 1, "0 or 1, seldom between");
    if (material.transmission > 0) {
        number("transmission", "transmission", static_cast<double>(material.transmission), 1, "goes through");
    }
    const float most = std::max({material.emissive.x, material.emissive.y, material.emissive.z});
    NumberRow emission{.label = "emission", .value = static_cast<double>(most), .unit = "nt"};
    emission.lower = 0;
    emission.logarithmic = most > 0;
    emission.words = "luminance of its brightest colour";
    const NumberChange change = state.fields.number(emission);
    const vec3 hue = most > 0 ? material.emissive / most : vec3(1);
    state.follow(change.doing, "emission" + of,
                 line("emissive", json_vector(hue * static_cast<float>(change.value))));
    ImGui::PopID();
}

// The materials of what is chosen, each once.
std::vector<std::uint32_t> materials_of(EditorState& state) {
    std::vector<std::uint32_t> found;
    editor::EditSession& session = state.session;
    const ecs::World& world = session.world();
    const AssetStore* store = world.try_resource<AssetStore>();
    for (const std::uint32_t node : state.chosen) {
        const ecs::Entity e = session.entity_of(node);
        const MeshInstances* meshes = e && world.alive(e) ? world.try_get<MeshInstances>(e) : nullptr;
        if (meshes == nullptr || store == nullptr) {
            continue;
        }
        for (const MeshHandle mesh : meshes->meshes) {
            const MaterialHandle material = store->material_of(mesh);
            for (std::uint32_t i = 0; i < session.model().materials.size(); ++i) {
                if (session.model().materials[i] != nullptr && session.material_handle(i) == material &&
                    std::ranges::find(found, i) == found.end()) {
                    found.push_back(i);
                }
            }
        }
    }
    return found;
}

void component_section(EditorState& state, const ecs::ComponentType& type,
                       const std::vector<const void*>& values) {
    const bool in_extras = type.in_extras;
    std::string title = type.name;
    std::ranges::replace(title, '_', ' ');
    ImGui::PushID(type.name.c_str());
    const bool open = heading(title.c_str());
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s", type.words.c_str());
    }
    if (in_extras && ImGui::BeginPopupContextItem("section")) {
        if (ImGui::MenuItem("take away")) {
            std::vector<std::string> lines;
            for (const std::uint32_t n : state.chosen) {
                lines.push_back(
                    fmt::format("unset {} {}", editor::word(state.session.path_of(n)), type.name));
            }
            state.run("take " + title + " away", std::move(lines));
        }
        ImGui::EndPopup();
    }
    if (open) {
        draw_component(state.fields, type, values,
                       [&](Doing doing, const std::string& field, const std::string& value) {
                           std::vector<std::string> lines;
                           for (const std::uint32_t n : state.chosen) {
                               lines.push_back(set_line(state.session.path_of(n), field, value));
                           }
                           state.follow(doing, field + " of " + whom(state), std::move(lines));
                       });
    }
    ImGui::PopID();
}

void add_component(EditorState& state) {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (!ImGui::BeginCombo("##add", "add a component")) {
        return;
    }
    for (const ecs::ComponentType& type : state.session.registry().components()) {
        if (!type.in_extras || type.runtime || type.opaque) {
            continue;
        }
        if (ImGui::Selectable(type.name.c_str())) {
            std::vector<std::string> lines;
            for (const std::uint32_t n : state.chosen) {
                lines.push_back(set_line(state.session.path_of(n), type.name, "{}"));
            }
            state.run("add " + type.name, std::move(lines));
        }
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s", type.words.c_str());
        }
    }
    ImGui::EndCombo();
}

}  // namespace

void draw_inspector(EditorState& state) {
    const EditModel& model = state.session.model();
    std::vector<std::uint32_t> there;
    for (const std::uint32_t n : state.chosen) {
        if (model.find(n) != nullptr) {
            there.push_back(n);
        }
    }
    state.chosen = there;
    if (there.empty()) {
        ImGui::TextDisabled("Nothing is chosen.");
        ImGui::TextDisabled("Click a thing in the picture or the tree.");
        return;
    }
    const ModelNode& first = model.node(there.front());
    const float names = std::round(ImGui::GetContentRegionAvail().x * 0.36f);
    state.fields.begin(names, state.unit);
    if (there.size() == 1) {
        std::string name = first.name;
        if (state.fields.text(kind_of(first), name, state.session.path_of(there.front()))) {
            state.run("rename " + editor::called(model, there.front()),
                      {fmt::format("rename {} {}", editor::word(state.session.path_of(there.front())),
                                   editor::word(name))});
        }
    } else {
        ImGui::Text("%zu things are chosen", there.size());
    }
    if (std::ranges::any_of(there, [&](std::uint32_t n) { return editor::light_of(model, n) != nullptr; }) &&
        heading("light")) {
        ImGui::PushID("light");
        draw_light(state, there);
        ImGui::PopID();
    }
    if (heading("transform")) {
        transform_rows(state);
    }
    const std::vector<std::uint32_t> materials = materials_of(state);
    if (!materials.empty() && heading("material")) {
        for (const std::uint32_t material : materials) {
            material_rows(state, material);
        }
    }
    // Everything that is declared and that all of them have.
    const ecs::World& world = state.session.world();
    for (const ecs::ComponentType& type : state.session.registry().components()) {
        if ((!type.in_extras && type.name != "camera") || type.opaque || type.runtime) {
            continue;
        }
        std::vector<const void*> values;
        for (const std::uint32_t n : there) {
            const ecs::Entity e = state.session.entity_of(n);
            if (const void* value = e && world.alive(e) ? ecs::get(world, e, type) : nullptr) {
                values.push_back(value);
            }
        }
        if (values.size() == there.size()) {
            component_section(state, type, values);
        }
    }
    ImGui::Spacing();
    add_component(state);
    if (there.size() == 1 && !first.extras.empty() && heading("extras", false)) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("%s", first.extras.c_str());
        ImGui::PopTextWrapPos();
    }
}

}  // namespace lanthorn::edit_window
