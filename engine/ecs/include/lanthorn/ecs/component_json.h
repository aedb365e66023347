// Declared components as JSON text: whole, by field, and among a glTF node's extras.
//
// Numbers, booleans, texts, arrays (vectors; quaternions x, y, z, w; matrices by columns) and objects are
// what they are in JSON; an enumeration is its choice's name, an absent optional is null, infinity is "inf",
// an entity is what EntityNames calls it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/ecs/registry.h"

namespace lanthorn::ecs {

// How JSON refers to entities. Without `name`: "entity 12v3". Without `find`: only null can be read.
struct EntityNames {
    std::function<Entity(std::string_view)> find;  // the null entity if no entity has that name
    std::function<std::string(Entity)> name;
};

// `place` ("door.open_angle") and what is wrong there: "is 5, expected a number from 0 to 3.1 rad".
struct JsonProblem {
    std::string place;
    std::string problem;
    // As a message has it: "door.open_angle is 5, expected a number from 0 to 3.1 rad"
    std::string line() const { return place + " " + problem; }
};

// All fields of one component but opaque ones, as an object.
std::string to_json(const ComponentType& type, const void* component, const EntityNames& names = {});

// A Markdown table of the components that may stand in extras, with what an author says of them: each field's
// name, values, default and words.
std::string list_markdown(const Registry& registry);

// Reads fields into a living component; those not named stay. Throws InputError for what is no JSON, for a
// field that is unknown, of another type or out of range; the component is unchanged then.
void from_json(const ComponentType& type, void* component, std::string_view json,
               const EntityNames& names = {});

// One field by its path: "door.open_angle", "local_transform.translation"; or a whole component,
// "door". Throw InputError for a path that is not declared, an entity without that component, a value that
// does not fit; ecs::Error for a dead entity. A write counts as a change.
std::string get_json(const Registry& registry, const World& world, Entity e, std::string_view path,
                     const EntityNames& names = {});
// Writes what get_json() reads. The component's check, too, must find the new value right.
void set_json(const Registry& registry, World& world, Entity e, std::string_view path, std::string_view json,
              const EntityNames& names = {});

// The value of a declared component, or null; `get_mut` counts as a write.
const void* get(const World& world, Entity e, const ComponentType& type);
// To write it: what is handed out counts as written now. Null, and ecs::Error for a dead entity, likewise.
void* get_mut(World& world, Entity e, const ComponentType& type);

// What a node's extras say of components: {"door": {"open_angle": 1.2}, "other": 7}.
//
// A key that is the name of a component (one that may stand in extras) is that component; fields left out
// have their defaults. Any other key belongs to another program and means nothing, unless its value is an
// object and its name is nearly a component's: that is a problem, taken for a slip of the pen.
struct ExtrasReading {
    std::vector<const ComponentType*> types;    // in the order of their declaration
    std::vector<std::shared_ptr<void>> values;  // likewise; never null
    std::vector<JsonProblem> skipped;           // components left out, and why
    std::vector<JsonProblem> ignored;           // unknown fields and components
};
// Bad extras do not throw: text that is no JSON is the one entry of `skipped`, an array or a number means
// nothing.
ExtrasReading read_extras(const Registry& registry, std::string_view extras, const EntityNames& names = {});

// The extras with the entity's components as they are now: what differs from what `extras` say in an
// author's fields is written, everything else stays as it was, text by text if nothing differs. Runtime
// fields and components are not written. Extras that are no object stay.
std::string write_extras(const Registry& registry, const World& world, Entity e, const std::string& extras,
                         const EntityNames& names = {});

}  // namespace lanthorn::ecs
