// set and unset: lights, cameras, components in extras, and what other programs keep there.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/scene/components.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::editor {

namespace {

using Json = nlohmann::json;

std::pair<std::string_view, std::string_view> split(std::string_view field) {
    const std::size_t dot = field.find('.');
    return {field.substr(0, dot), dot == std::string_view::npos ? std::string_view() : field.substr(dot + 1)};
}

// References to entities, for checking: any node's name is one.
ecs::EntityNames names_in(const EditModel& model) {
    ecs::EntityNames names;
    names.find = [&model](std::string_view name) {
        for (std::uint32_t i = 0; i < model.nodes.size(); ++i) {
            if (model.nodes[i] != nullptr && model.nodes[i]->name == name) {
                return ecs::Entity{i, 1};
            }
        }
        return ecs::kNullEntity;
    };
    names.name = [&model](ecs::Entity e) {
        const ModelNode* node = model.find(e.index);
        return node != nullptr ? node->name : std::string();
    };
    return names;
}

Json extras_of(const ModelNode& node) {
    return node.extras.empty() ? Json::object() : parse_json(node.extras, "extras");
}

void put_extras(Operation& op, std::uint32_t node, const Json& extras) {
    op.model.alter(node).extras = extras.empty() ? std::string() : extras.dump();
}

// The extras must be an object to have members.
Json object_extras(Operation& op, std::uint32_t node) {
    Json extras = extras_of(op.model.node(node));
    if (!extras.is_object()) {
        op.refuse(fmt::format("the extras of '{}' are no object, expected one to have members of",
                              path_of(op.model, node)));
    }
    return extras;
}

// A member of the extras as it is, of whatever program.
void set_member(Operation& op, std::uint32_t node, std::string_view key, const std::string& value) {
    Json extras = object_extras(op, node);
    const std::string name(key);
    op.result.before = extras.contains(name) ? extras[name].dump() : std::string();
    extras[name] = parse_json(json_of(value), fmt::format("extras.{}", key));
    op.result.after = extras[name].dump();
    put_extras(op, node, extras);
}

// A component as the extras say it, with one field or all of it replaced. The declaration must find it right.
void set_component(Operation& op, std::uint32_t node, std::string_view field, const std::string& value) {
    const auto [name, rest] = split(field);
    const ecs::ComponentType* type = op.context.registry.find(name);
    if (type == nullptr || !type->in_extras) {
        std::string nearest;
        try {
            op.context.registry.find_or_throw(name);
        } catch (const InputError& error) {
            nearest = std::string("; ") + error.what();
        }
        op.refuse(
            fmt::format("found '{}', expected light, camera, extras.KEY or a component{}", name, nearest));
    }
    Json extras = object_extras(op, node);
    const std::string key(name);
    const bool is_there = extras.contains(key);
    Json stated = is_there ? extras[key] : Json::object();
    if (!stated.is_object()) {  // {"collider": "box"}
        stated = type->brief_field.empty() ? Json::object() : Json{{type->brief_field, stated}};
    }
    op.result.before = is_there ? extras[key].dump() : std::string();
    const Json given = parse_json(json_of(value), fmt::format("{}", field));
    if (rest.empty()) {
        if (!given.is_object()) {
            op.refuse(fmt::format("found {}, expected an object of {}'s fields", given.dump(), name));
        }
        stated = given;
    } else {
        Json* at = &stated;
        std::string_view path = rest;
        while (true) {
            const auto [first, more] = split(path);
            at = &(*at)[std::string(first)];
            if (more.empty()) {
                break;
            }
            path = more;
        }
        *at = given;
    }
    const std::shared_ptr<void> living = type->clone(type->initial.get());
    try {
        ecs::from_json(*type, living.get(), stated.dump(), names_in(op.model));
    } catch (const InputError& error) {
        op.refuse(fmt::format("{}: {}", path_of(op.model, node), error.what()));
    }
    if (const std::string problem = ecs::problem_of(*type, living.get()); !problem.empty()) {
        op.refuse(fmt::format("{}: {}.{}", path_of(op.model, node), name, problem));
    }
    op.result.after = stated.dump();
    extras[key] = stated;
    put_extras(op, node, extras);
}

void set_camera(Operation& op, std::uint32_t node, std::string_view field, const std::string& value) {
    const std::uint32_t index = op.model.node(node).camera;
    if (index >= op.model.cameras.size() || op.model.cameras[index] == nullptr) {
        op.refuse(fmt::format("'{}' has no camera, expected a node with one", path_of(op.model, node)));
    }
    const ecs::ComponentType& type = *op.context.registry.find<CameraComponent>();
    CameraComponent camera{*op.model.cameras[index]};
    op.result.before = ecs::to_json(type, &camera);
    ecs::from_json(type, &camera, Json{{std::string(field), parse_json(json_of(value), "value")}}.dump());
    const Camera& now = camera.camera;
    if (now.z_far != 0 && !(now.z_far > now.z_near)) {
        op.refuse(
            fmt::format("z_far is {}, expected more than z_near, {}, or 0: infinite", now.z_far, now.z_near));
    }
    op.result.after = ecs::to_json(type, &camera);
    op.model.cameras[index] = std::make_shared<const Camera>(now);
}

void set(Operation& op) {
    op.expect_count({3});
    const std::uint32_t node = op.node_at_word(1);
    const std::string path = path_of(op.model, node);
    const std::string field = op.word_at(2), value = op.word_at(3);
    const auto [first, rest] = split(field);
    op.result.path = path;
    op.result.touched = {node};
    op.say({word(path), word(field), word(value)});
    if (first == "light") {
        apply_light_value(op, node, rest, value);
        const std::string field_of =
            std::string("light.") + (rest == "kelvin"                   ? "colour"
                                     : rest == "lumen" || rest == "lux" ? "intensity"
                                                                        : std::string(rest));
        op.say({word(path), word(field_of), word(op.result.after)});
    } else if (first == "camera") {
        set_camera(op, node, rest, value);
    } else if (first == "extras" && !rest.empty()) {
        set_member(op, node, rest, value);
    } else {
        set_component(op, node, field, value);
    }
}

void unset(Operation& op) {
    op.expect_count({2});
    const std::uint32_t node = op.node_at_word(1);
    const std::string path = path_of(op.model, node);
    const std::string field = op.word_at(2);
    op.result.path = path;
    op.result.touched = {node};
    op.say({word(path), word(field)});
    if (field == "light" || field == "camera") {
        ModelNode& altered = op.model.alter(node);
        std::uint32_t& held = field == "light" ? altered.light : altered.camera;
        if (held == kNone) {
            op.refuse(fmt::format("'{}' has no {}", path, field));
        }
        op.result.before = std::to_string(held);
        held = kNone;
        return;
    }
    const std::string key = field.starts_with("extras.") ? field.substr(7) : field;
    Json extras = object_extras(op, node);
    if (!extras.contains(key)) {
        op.refuse(fmt::format("'{}' has no '{}'", path, key));
    }
    op.result.before = extras[key].dump();
    extras.erase(key);
    put_extras(op, node, extras);
}

}  // namespace

std::string json_of(const std::string& text) {
    return json_if_valid(text) ? text : Json(text).dump();
}

void apply_value(Operation& op) {
    op.name() == "set" ? set(op) : unset(op);
}

}  // namespace lanthorn::editor
