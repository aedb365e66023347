#include "tools/editor/core/node_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/scene/components.h"
#include "tools/editor/core/light_units.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::editor {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const EditModel& model, std::uint32_t node, std::string_view field) {
    throw InputError(fmt::format("'{}' has no '{}'", path_of(model, node), field));
}

template <class V>
std::string numbers(const V& v) {
    std::vector<std::string> all;
    all.reserve(static_cast<std::size_t>(v.length()));
    for (int i = 0; i < static_cast<int>(v.length()); ++i) {
        all.push_back(number(v[i]));
    }
    return fmt::format("[{}]", fmt::join(all, ","));
}

// The member at "a.b" of an object.
std::string member(const Json& object, std::string_view path, const EditModel& model, std::uint32_t node,
                   std::string_view field) {
    const Json* at = &object;
    while (!path.empty()) {
        const std::size_t dot = path.find('.');
        const std::string key(path.substr(0, dot));
        if (!at->is_object() || !at->contains(key)) {
            refuse(model, node, field);
        }
        at = &(*at)[key];
        path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
    }
    return at->dump();
}

std::string light_value(const EditModel& model, const ecs::Registry& registry, std::uint32_t node,
                        std::string_view rest) {
    const Light* light = light_of(model, node);
    if (light == nullptr) {
        refuse(model, node, "light");
    }
    if (rest == "lumen") {
        return number(lumen(*light));
    }
    if (rest == "lux") {
        return number(lux_at_one_metre(*light));
    }
    if (rest == "kelvin") {
        return number(kelvin_of(light->colour).kelvin);
    }
    const LightComponent component{*light};
    return member(parse_json(ecs::to_json(*registry.find<LightComponent>(), &component), "light"), rest,
                  model, node, fmt::format("light.{}", rest));
}

std::string camera_value(const EditModel& model, const ecs::Registry& registry, std::uint32_t node,
                         std::string_view rest) {
    const std::uint32_t index = model.node(node).camera;
    if (index >= model.cameras.size() || model.cameras[index] == nullptr) {
        refuse(model, node, "camera");
    }
    const CameraComponent component{*model.cameras[index]};
    return member(parse_json(ecs::to_json(*registry.find<CameraComponent>(), &component), "camera"), rest,
                  model, node, fmt::format("camera.{}", rest));
}

std::string component_value(const EditModel& model, const ecs::Registry& registry, std::uint32_t node,
                            std::string_view name, std::string_view rest) {
    ecs::EntityNames names;
    names.find = [&model](std::string_view wanted) {
        for (std::uint32_t i = 0; i < model.nodes.size(); ++i) {
            if (model.nodes[i] != nullptr && model.nodes[i]->name == wanted) {
                return ecs::Entity{i, 1};
            }
        }
        return ecs::kNullEntity;
    };
    names.name = [&model](ecs::Entity e) {
        return model.find(e.index) == nullptr ? "" : model.node(e.index).name;
    };
    const ecs::ExtrasReading reading = ecs::read_extras(registry, model.node(node).extras, names);
    for (std::size_t i = 0; i < reading.types.size(); ++i) {
        if (reading.types[i]->name == name) {
            return member(
                parse_json(ecs::to_json(*reading.types[i], reading.values[i].get(), names), "component"),
                rest, model, node, fmt::format("{}.{}", name, rest));
        }
    }
    refuse(model, node, name);
}

}  // namespace

std::string node_value(const EditModel& model, const ecs::Registry& registry, std::uint32_t node,
                       std::string_view field) {
    const ModelNode& at = model.node(node);
    const std::size_t dot = field.find('.');
    const std::string_view first = field.substr(0, dot);
    const std::string_view rest = dot == std::string_view::npos ? std::string_view() : field.substr(dot + 1);
    if (field == "name") {
        return Json(at.name).dump();
    }
    if (field == "parent") {
        return Json(path_of(model, at.parent)).dump();
    }
    if (field == "visible") {
        return at.visible ? "true" : "false";
    }
    if (field == "translation") {
        return numbers(at.local.translation);
    }
    if (field == "rotation") {
        return numbers(
            vec4(at.local.rotation.x, at.local.rotation.y, at.local.rotation.z, at.local.rotation.w));
    }
    if (field == "scale") {
        return numbers(at.local.scale);
    }
    if (first == "light") {
        return light_value(model, registry, node, rest);
    }
    if (first == "camera") {
        return camera_value(model, registry, node, rest);
    }
    if (first == "extras") {
        return member(at.extras.empty() ? Json::object() : parse_json(at.extras, "extras"), rest, model, node,
                      field);
    }
    return component_value(model, registry, node, first, rest);
}

std::string material_value(const EditModel& model, std::string_view material, std::string_view field) {
    return factor_of(*model.materials[material_named(model, material)], field);
}

bool means_the_same(std::string_view a, std::string_view b) {
    const auto x = json_if_valid(a), y = json_if_valid(b);
    if (!x || !y) {
        return a == b;
    }
    std::function<bool(const nlohmann::ordered_json&, const nlohmann::ordered_json&)> has_all;
    const std::function<bool(const nlohmann::ordered_json&, const nlohmann::ordered_json&)> same =
        [&](const nlohmann::ordered_json& p, const nlohmann::ordered_json& q) {
            if (p.is_number() && q.is_number()) {
                const double m = p.get<double>(), n = q.get<double>();
                return std::abs(m - n) <= 1e-6 * std::max({std::abs(m), std::abs(n), 1e-3});
            }
            if (p.is_array() && q.is_array()) {
                return p.size() == q.size() && std::equal(p.begin(), p.end(), q.begin(), same);
            }
            if (p.is_object() && q.is_object()) {
                return p.size() == q.size() && has_all(p, q);
            }
            return p == q;
        };
    has_all = [&](const nlohmann::ordered_json& p, const nlohmann::ordered_json& q) {
        for (const auto& [key, value] : p.items()) {
            if (!q.contains(key) || !same(value, q[key])) {
                return false;
            }
        }
        return true;
    };
    return same(*x, *y);
}

}  // namespace lanthorn::editor
