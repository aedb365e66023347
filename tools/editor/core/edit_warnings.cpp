#include "tools/editor/core/edit_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "lanthorn/core/colour.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"
#include "tools/editor/core/light_units.h"
#include "tools/editor/core/lights_table.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"
#include "tools/editor/core/scene_clips.h"

namespace lanthorn::editor {

namespace {

constexpr double kBulb = 65;                         // cd: a household bulb of 800 lm
constexpr double kTooBright = 3000;                  // cd: brighter than any lamp in a house
constexpr double kLumenAWatt = 683;                  // what Blender's exporter takes a watt for (glTF#2214)
constexpr double kNoon = 130000;                     // lux: more than the sun gives
constexpr double kLargest = 2000, kSmallest = 0.05;  // metres: of scenes that people make in metres

class Finder {
  public:
    explicit Finder(EditSession& session) : session_(session), model_(session.model()) {}

    std::vector<EditWarning> run() {
        tell_files();
        tell_clip();
        tell_guest();
        tell_lights();
        tell_materials();
        tell_nodes();
        tell_size();
        return std::move(found_);
    }

  private:
    void add(const char* kind, std::string text, std::uint32_t node = kNone, std::string fix = {}) {
        found_.push_back({kind, std::move(text), node, std::move(fix)});
    }

    void tell_files() {
        for (const LeftCommand& left : session_.left()) {
            add("left", fmt::format("'{}' was not done again: {}", left.command.text, left.why));
        }
        for (const std::string& note : session_.notes()) {
            add("mended", note);
        }
    }

    void tell_clip() {
        const std::string named = named_clip(session_.world());
        const std::vector<ClipRow> clips = clip_rows(session_);
        if (!named.empty() && named != "none" && start_clip(session_, clips) == "none") {
            add("clip",
                clips.empty()
                    ? fmt::format("the file begins with the clip '{}', and has no clips", named)
                    : fmt::format("the file begins with the clip '{}', which is none of its clips", named),
                kNone, clips.empty() ? std::string() : start_clip_line(session_, clips.front().key));
        }
    }

    void tell_guest() {
        if (!session_.guests().empty()) {
            const bool has_sun = std::ranges::any_of(session_.model().in_order(), [&](std::uint32_t node) {
                return light_of(session_.model(), node) != nullptr;
            });
            add("guest",
                has_sun ? "the file has a sun and no sky; one is lent, and is not saved"
                        : "the file has no light of its own; one is lent, and is not saved",
                kNone, "adopt");
        }
    }

    void tell_brightest(const std::vector<LightRow>& rows) {
        const LightRow* brightest = nullptr;
        for (const LightRow& row : rows) {
            const bool is_lamp = row.type != LightType::directional;
            if (is_lamp && (brightest == nullptr || row.candela > brightest->candela)) {
                brightest = &row;
            }
        }
        if (brightest != nullptr && brightest->candela > kTooBright) {
            add("watts",
                fmt::format("the brightest lamp, {}, has {:.0f} cd (a household bulb: {:.0f}): watts of "
                            "Blender's? {:.0f} cd "
                            "divided by 683",
                            brightest->name, brightest->candela, kBulb, brightest->candela / kLumenAWatt),
                brightest->node, "scale-lights " + number(1 / kLumenAWatt));
        }
    }

    void tell_light(const LightRow& row) {
        const Light& light = *light_of(model_, row.node);
        const std::string path = word(row.path);
        if (!(row.candela > 0)) {
            add("dark", fmt::format("{} shines nothing", row.name), row.node, fmt::format("delete {}", path));
        }
        const bool is_far = light.type == LightType::directional;
        if (is_far && row.candela > kNoon) {
            add("noon", fmt::format("{} gives {:.0f} lx, more than the sun at noon", row.name, row.candela),
                row.node, fmt::format("set {} light.lux 100000", path));
        }
        const double at_end = row.candela / (row.range * row.range);
        if (!is_far && std::isfinite(row.range) && at_end > 1) {
            add("range",
                fmt::format("{} is cut off at {:.3g} m, where it would still give {:.2g} lx", row.name,
                            row.range, at_end),
                row.node, fmt::format("set {} light.range inf", path));
        }
        const float most = std::max({light.colour.x, light.colour.y, light.colour.z});
        if (most > 0 && std::abs(most - 1) > 1e-3f) {
            const vec3 plain = light.colour / most;
            add("colour",
                fmt::format("{} has brightness in its colour, whose largest part is {:.3g}, expected 1",
                            row.name, most),
                row.node,
                fmt::format("set {0} light.colour [{1},{2},{3}]\nset {0} light.intensity {4}", path,
                            number(plain.x), number(plain.y), number(plain.z),
                            number(light.intensity * most)));
        }
        if (row.users > 1) {
            add("shared",
                fmt::format("{} shares its light with {} other node{}: an edit alters all", row.name,
                            row.users - 1, row.users > 2 ? "s" : ""),
                row.node);
        }
        if (!row.shown) {
            add("hidden", fmt::format("{} is hidden, and lights nothing", row.name), row.node,
                model_.node(row.node).visible ? std::string() : fmt::format("show {}", path));
        }
        if (model_.node(row.node).name.empty()) {
            add("unnamed", fmt::format("{} has no name: another export may not find it again", row.name),
                row.node, fmt::format("rename {} lamp-{}", path, row.node));
        }
        if (std::abs(row.kelvin.distance) > 0.05) {
            add("tint",
                fmt::format("{} is {}: no black body has its colour", row.name,
                            row.kelvin.distance > 0 ? "green" : "pink or blue"),
                row.node);
        }
    }

    void tell_lights() {
        const std::vector<LightRow> rows = lights_table(model_);
        tell_brightest(rows);
        for (const LightRow& row : rows) {
            tell_light(row);
        }
    }

    void tell_materials() {
        for (std::uint32_t i = 0; i < model_.materials.size(); ++i) {
            if (model_.materials[i] == nullptr) {
                continue;
            }
            const Material& material = *model_.materials[i];
            const std::string name = material_name(model_, i);
            const vec3 colour(material.base_colour);
            const double albedo = luminance(dvec3(colour));
            const bool is_paint = !material.base_colour_texture.present() && material.metallic < 0.5f &&
                                  material.transmission == 0 && !material.emits();
            const auto repaint = [&](double to) {
                const vec3 c = glm::min(colour * static_cast<float>(to / std::max(albedo, 1e-6)), vec3(1));
                return fmt::format("set-material {} base_colour [{},{},{},{}]", word(name), number(c.x),
                                   number(c.y), number(c.z), number(material.base_colour.w));
            };
            if (is_paint && albedo > 0.95) {
                add("albedo",
                    fmt::format("material {} reflects {:.0f} % of light; fresh snow 90 %", name,
                                100 * albedo),
                    kNone, repaint(0.85));
            } else if (is_paint && albedo < 0.02) {
                add("albedo",
                    fmt::format("material {} reflects {:.1f} % of light; coal 4 %", name, 100 * albedo),
                    kNone,
                    albedo > 0 ? repaint(0.04)
                               : fmt::format("set-material {} base_colour [0.04,0.04,0.04,{}]", word(name),
                                             number(material.base_colour.w)));
            }
            if (!material.metallic_roughness_texture.present() && material.metallic > 0.1f &&
                material.metallic < 0.9f) {
                add("metal",
                    fmt::format("material {} is metal by {:.2g}, expected 0 or 1", name, material.metallic),
                    kNone,
                    fmt::format("set-material {} metallic {}", word(name), material.metallic < 0.5f ? 0 : 1));
            }
            const float brightest = std::max({material.emissive.x, material.emissive.y, material.emissive.z});
            if (brightest > 1e5f) {
                add("glare",
                    fmt::format("material {} emits {:.2g} nits; a fluorescent tube 1e4", name, brightest));
            }
        }
    }

    void tell_nodes() {
        std::map<std::pair<std::uint32_t, std::string>, std::size_t> names;
        for (const std::uint32_t node : model_.in_order()) {
            const ModelNode& at = model_.node(node);
            if (!at.name.empty() && ++names[{at.parent, at.name}] == 2) {
                add("names", fmt::format("'{}' is the name of several nodes at one place", at.name), node,
                    fmt::format("rename {} {}", word(path_of(model_, node)),
                                word(fmt::format("{}-{}", at.name, node))));
            }
            const vec3& scale = at.local.scale;
            if (scale.x == 0 || scale.y == 0 || scale.z == 0) {
                add("flat", fmt::format("{} has no size along an axis", called(model_, node)), node,
                    fmt::format("scale {} 1", word(path_of(model_, node))));
            }
        }
    }

    void tell_size() {
        const ecs::World& world = std::as_const(session_.app()).world();
        const AssetStore* store = world.try_resource<AssetStore>();
        dvec3 lower(std::numeric_limits<double>::infinity()), upper(-lower);
        for (const ecs::Entity e : session_.entities()) {
            const MeshInstances* meshes = e == ecs::kNullEntity ? nullptr : world.try_get<MeshInstances>(e);
            for (std::size_t k = 0; meshes != nullptr && store != nullptr && k < meshes->meshes.size(); ++k) {
                const Aabb& box = store->get(meshes->meshes[k]).bounds;
                const dmat4 to_world = model_.world_matrix(session_.node_of(e));
                for (int corner = 0; corner < 8 && !box.empty(); ++corner) {
                    const dvec3 at(corner & 1 ? box.lower.x : box.upper.x,
                                   corner & 2 ? box.lower.y : box.upper.y,
                                   corner & 4 ? box.lower.z : box.upper.z);
                    const dvec3 point(to_world * dvec4(at, 1));
                    lower = glm::min(lower, point);
                    upper = glm::max(upper, point);
                }
            }
        }
        const double size = glm::length(upper - lower);
        if (!(lower.x <= upper.x) || (size <= kLargest && size >= kSmallest)) {
            return;
        }
        std::string fix;
        if (model_.roots.size() == 1) {
            const Transform& local = model_.node(model_.roots[0]).local;
            const double factor = size > kLargest ? 0.01 : 100;
            fix = fmt::format("scale {} {} {} {}", word(path_of(model_, model_.roots[0])),
                              number(local.scale.x * factor), number(local.scale.y * factor),
                              number(local.scale.z * factor));
        }
        add("units",
            fmt::format("the scene is {:.3g} m from corner to corner: {}?", size,
                        size > kLargest ? "centimetres or millimetres" : "kilometres"),
            kNone, fix);
        for (const LightRow& row : lights_table(model_)) {
            const double away = glm::length(glm::max(lower - row.at, glm::max(row.at - upper, dvec3(0))));
            if (row.type != LightType::directional && away > 3 * size) {
                add("far", fmt::format("{} stands {:.3g} m outside of the scene", row.name, away), row.node);
            }
        }
    }

    EditSession& session_;
    const EditModel& model_;
    std::vector<EditWarning> found_;
};

}  // namespace

std::vector<EditWarning> edit_warnings(EditSession& session) {
    return Finder(session).run();
}

}  // namespace lanthorn::editor
