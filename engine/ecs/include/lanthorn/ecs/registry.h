// What components and resources there are: each is declared once, field by field, and copying, comparing,
// JSON, glTF extras, state hashes, snapshots and inspectors are made from these declarations.
//
//   struct Door { float open_angle = 1.9f; float angle = 0; bool open = false; };
//
//   void declare_door(ecs::Registry& registry) {
//       using ecs::field;
//       registry.component<Door>("door", "a leaf that turns about its node's Y axis",
//           field("open_angle", &Door::open_angle).unit("rad").range(0, 3.1).words("how far it opens"),
//           field("angle", &Door::angle).unit("rad").runtime().words("how far it is open now"),
//           field("open", &Door::open).runtime().words("whether it is open, or on its way"));
//   }
//
// A field left out does not compile. Defaults are those of a default-constructed Door.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "lanthorn/ecs/error.h"
#include "lanthorn/ecs/member_count.h"
#include "lanthorn/ecs/type_info.h"
#include "lanthorn/ecs/value_type.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {

// One member that is being declared; made by field().
template <class T, class M>
class FieldDeclaration {
  public:
    FieldDeclaration(std::string name, M T::*member) : member_(member) { field_.name = std::move(name); }

    // "m", "rad/s"; without: a plain number.
    FieldDeclaration&& unit(std::string text) && { return set(field_.unit, std::move(text)); }
    // A sentence or two for people who edit it.
    FieldDeclaration&& words(std::string text) && { return set(field_.words, std::move(text)); }
    // Of every number in the value: both ends are allowed values. Without it: every finite number; an
    // infinite end allows infinity ("inf" in JSON).
    FieldDeclaration&& range(double lower, double upper) && {
        set(field_.lower, lower);
        return set(field_.upper, upper);
    }
    // Like range, the lower end not allowed.
    FieldDeclaration&& more_than(double lower, double upper = std::numeric_limits<double>::max()) && {
        set(field_.lower_excluded, true);
        return std::move(*this).range(lower, upper);
    }
    // The names of an enumeration's values 0, 1, 2, ...
    FieldDeclaration&& choices(std::vector<std::string> names) && {
        return set(field_.choices, std::move(names));
    }
    // What a larger value costs.
    FieldDeclaration&& cost(std::string text) && { return set(field_.cost, std::move(text)); }
    // The simulation writes it: a timer, a momentary angle. State like any other, but no editor shows it and
    // no level is written with it. Without this: an author's, who says how the level begins.
    FieldDeclaration&& runtime() && { return set(field_.runtime, true); }
    // No state: derived from other fields, or a cache. Copied, but not hashed, and not read from extras.
    FieldDeclaration&& transient() && { return set(field_.transient, true); }
    // The structure's fields stand in JSON beside this one's neighbours, not in a separate object.
    FieldDeclaration&& flat() && { return set(field_.flat, true); }
    // A type that nothing is known of but how to copy it: not hashed, not in JSON, not in stored snapshots.
    FieldDeclaration&& opaque() && { return set(opaque_, true); }

    const Field& info() const { return field_; }  // what has been declared so far
    M T::*member() const { return member_; }      // which member it is of the structure
    bool is_opaque() const { return opaque_; }    // nothing is known of the type but how to copy it

  private:
    template <class V>
    FieldDeclaration&& set(V& value, V to) {
        value = std::move(to);
        return std::move(*this);
    }
    Field field_;
    M T::*member_;
    bool opaque_ = false;
};

// Begins the declaration of a member; `name` is its key in JSON: lower-case words joined by _.
template <class T, class M>
FieldDeclaration<T, M> field(std::string name, M T::*member) {
    return FieldDeclaration<T, M>(std::move(name), member);
}

// A const member: changed only by inserting the whole component again.
template <class T, class M>
FieldDeclaration<T, M> field(std::string name, const M T::*member) {
    return FieldDeclaration<T, M>(std::move(name), const_cast<M T::*>(member));
}

// As many fields as T has members.
template <class T, class... Fields>
concept DeclaresEveryMember = std::is_aggregate_v<T> && kMemberCount<T>
== sizeof...(Fields);

// A declared component or resource.
struct DeclaredType {
    std::string name;   // "door"; the key in extras and the part of the state's hash
    std::string words;  // one sentence for people
    const ValueType* value = nullptr;
    std::shared_ptr<const void> initial;  // a default-constructed one; null for opaque types
    bool transient = false;               // no state: derived, or a cache; not hashed
    bool runtime = false;                 // the simulation adds and writes it; all its fields are runtime
    bool derived = false;                 // hooks of other components keep it; clones get it from these
    bool in_extras = true;                // read from glTF extras
    bool opaque = false;                  // copied, and nothing else is known of it
    std::string brief_field;              // what a value that is no object stands for; empty: nothing
    // What is wrong with a value though each field is in its range; empty: nothing.
    std::function<std::string(const void*)> check;
    void (*copy)(void* raw, const void* from) = nullptr;    // constructs
    void (*assign)(void* to, const void* from) = nullptr;   // to a living one
    std::shared_ptr<void> (*clone)(const void*) = nullptr;  // on the heap
};

// What is wrong with a value that a program made: "open_angle is 5, expected a number from 0 to 3.1 rad".
// Empty: nothing.
std::string problem_of(const DeclaredType& type, const void* value);

// A declared component, handled without knowing its C++ type.
struct ComponentType : DeclaredType {
    const ComponentInfo* info = nullptr;
    void (*insert)(World&, Entity, const void* value) = nullptr;  // a copy; adds or replaces
    void (*remove)(World&, Entity) = nullptr;
};

// A declared resource, handled likewise.
struct ResourceType : DeclaredType {
    TypeId id = 0;
    const void* (*get)(const World&) = nullptr;           // null if absent
    void* (*get_mut)(World&) = nullptr;                   // a write
    void (*insert)(World&, const void* value) = nullptr;  // a copy; adds or replaces
    void (*remove)(World&) = nullptr;
};

// What is not a field's matter; valid until the registry is destroyed.
template <class T>
class TypeDeclaration {
  public:
    TypeDeclaration(DeclaredType& type, ValueType* value) : type_(type), value_(value) {}
    // The simulation adds and writes it: no level is written with it. State all the same.
    TypeDeclaration& runtime() {
        type_.runtime = true;
        for (std::size_t i = 0; value_ != nullptr && i < value_->fields.size(); ++i) {
            value_->fields[i].runtime = true;
        }
        return *this;
    }
    // No state: derived from other components, or a cache. Copied, but not hashed.
    TypeDeclaration& transient() {
        type_.transient = true;
        return *this;
    }
    // Kept by the hooks of other components, which bring it to clones too.
    TypeDeclaration& derived() {
        type_.derived = true;
        return *this;
    }
    // Never read from glTF extras: the file says it elsewhere, or must not.
    TypeDeclaration& not_in_extras() {
        type_.in_extras = false;
        return *this;
    }
    // In extras {"collider": "box"} stands for {"collider": {"shape": "box"}}.
    TypeDeclaration& briefly(std::string field) {
        type_.brief_field = std::move(field);
        return *this;
    }
    // Tells what is wrong with a value though each field is in its range, field first: "height is 1,
    // expected at least twice the radius". Empty: nothing.
    TypeDeclaration& check(std::function<std::string(const T&)> says) {
        type_.check = [says = std::move(says)](const void* value) {
            return says(*static_cast<const T*>(value));
        };
        return *this;
    }

  private:
    DeclaredType& type_;
    ValueType* value_;  // null: opaque
};

class Registry {
  public:
    Registry();
    Registry(const Registry&) = delete;
    Registry& operator=(const Registry&) = delete;

    // Throws Error for a name or type that is declared already, a malformed name (expected lower-case words
    // joined by _), a field or member that is given twice, an enumeration without choices, a default out of
    // its range, a structure within that is not declared.
    template <class T, class... Ms>
    requires DeclaresEveryMember<T, Ms...> TypeDeclaration<T> component(std::string name, std::string words,
                                                                        FieldDeclaration<T, Ms>... fields) {
        check_name(name);
        ValueType& value = add_structure<T>(name, std::move(fields)...);
        return TypeDeclaration<T>(add_component<T>(std::move(name), std::move(words), value), &value);
    }
    // A component that is no aggregate, or that nothing should look into: copied, never hashed or written.
    template <class T>
    TypeDeclaration<T> opaque_component(std::string name, std::string words) {
        check_name(name);
        ComponentType& type = add_component<T>(std::move(name), std::move(words), opaque_type<T>());
        type.opaque = type.transient = true;
        type.in_extras = false;
        return TypeDeclaration<T>(type, nullptr);
    }
    // A resource that belongs to the world's state.
    template <class T, class... Ms>
    requires DeclaresEveryMember<T, Ms...> TypeDeclaration<T> resource(std::string name, std::string words,
                                                                       FieldDeclaration<T, Ms>... fields) {
        check_name(name);
        ValueType& value = add_structure<T>(name, std::move(fields)...);
        return TypeDeclaration<T>(add_resource<T>(std::move(name), std::move(words), value), &value);
    }
    // A structure that fields are made of: Transform.
    template <class T, class... Ms>
    requires DeclaresEveryMember<T, Ms...>
    void structure(const std::string& name, FieldDeclaration<T, Ms>... fields) {
        add_structure<T>(name, std::move(fields)...);
    }

    // In the order of declaration; addresses stay.
    const std::deque<ComponentType>& components() const { return components_; }
    // Likewise, and in the order in which snapshots and hashes go through them.
    const std::deque<ResourceType>& resources() const { return resources_; }
    // Null if it is not declared. O(log n).
    const ComponentType* find(std::string_view name) const;
    // By the id of component_info(); null if it is not declared. O(1).
    const ComponentType* find(TypeId id) const;
    // By the C++ type; null if it is not declared. O(1).
    template <Component T>
    const ComponentType* find() const {
        return find(component_info<T>().id);
    }
    // The same, but throws InputError naming the nearest declared name.
    const ComponentType& find_or_throw(std::string_view name) const;

    // Of everything declared, types and names; another schema reads another world.
    std::uint64_t schema_hash() const;

  private:
    template <class T>
    ComponentType& add_component(std::string name, std::string words, const ValueType& value);
    template <class T>
    ResourceType& add_resource(std::string name, std::string words, const ValueType& value);
    template <class T>
    void fill(DeclaredType& type, std::string name, std::string words, const ValueType& value);
    template <class T, class... Ms>
    ValueType& add_structure(const std::string& name, FieldDeclaration<T, Ms>... fields);
    template <class T, class M>
    void add_field(const std::string& owner, ValueType& structure, const T& sample,
                   FieldDeclaration<T, M> declared);
    template <class M>
    const ValueType& value_type(const std::string& owner);
    template <class M>
    const ValueType& opaque_type();

    const ValueType* find_value(const void* tag) const;
    ValueType& keep(const void* tag, ValueType type);
    void check_name(const std::string& name) const;
    [[noreturn]] static void throw_undeclared(const std::string& owner, std::string_view type);
    static void join_field(const std::string& owner, ValueType& structure, Field field);
    static void finish_structure(const std::string& owner, ValueType& structure, const void* sample);

    std::deque<ValueType> values_;
    std::map<const void*, ValueType*> value_of_tag_;
    std::deque<ComponentType> components_;
    std::deque<ResourceType> resources_;
    std::map<std::string, const DeclaredType*, std::less<>> by_name_;
    std::vector<const ComponentType*> by_id_;  // by component id; null: not declared
};

}  // namespace lanthorn::ecs

#include "lanthorn/ecs/registry_inl.h"
