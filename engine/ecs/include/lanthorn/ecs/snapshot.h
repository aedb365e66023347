// A world put aside, to go back to: all declared components of all entities, the entities' numbers, and the
// declared resources.
//
//   const Snapshot before = Snapshot::save(world, registry);
//   ...
//   before.restore(world);    // and what happens next is what happened after save(), bit for bit
//
// Handles that were valid then are valid again, the next entity gets the number it got, rows lie in the order
// they had. What differs from the present counts as changed at World::now(), the rest keeps its history.
// Events stay. Hooks on components do not run, also for what goes: what they keep in declared components is
// part of the snapshot.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/ecs/entity_table.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {

// Values of one component, in a row. Those of trivial components are copied as bytes.
class SnapshotColumn {
  public:
    SnapshotColumn(const ComponentType& type, std::size_t rows);
    SnapshotColumn(SnapshotColumn&& other) noexcept;
    SnapshotColumn& operator=(SnapshotColumn&&) = delete;
    ~SnapshotColumn();

    const ComponentType& type() const { return *type_; }  // of all its values
    // The value `i`, which must be one of those there are.
    const void* row(std::size_t i) const { return data_ + i * type_->info->size; }
    // The same to write.
    void* row(std::size_t i) { return data_ + i * type_->info->size; }
    // Copies `count` values that lie in a row behind those there are.
    void append(const void* values, std::size_t count);

  private:
    const ComponentType* type_;
    std::byte* data_;
    std::size_t rows_ = 0;  // constructed
};

class Snapshot {
  public:
    Snapshot(Snapshot&&) = default;

    // The registry must outlive the snapshot. Throws Error for a component that is not declared, naming it
    // and an entity that has it. O(bytes of components).
    static Snapshot save(const World& world, const Registry& registry);

    // Throws Error while a query iterates. O(bytes of components).
    void restore(World& world) const;

    std::size_t size() const;  // entities

    // To be stored: with the version of this form and what is declared. Components and fields that are
    // opaque are left out; from_bytes().restore() leaves them as they are on the entities that live on.
    std::string to_bytes() const;
    // Where other components, fields, choices or resources are declared than were when the bytes were
    // written, values are found by name: what is new is left as it is on the entities that live on, and has
    // its default on others; numbers become the type, and come into the range, of today. Throws InputError
    // naming `source` for bytes of another form or version, and for damage.
    static Snapshot from_bytes(std::string_view bytes, const Registry& registry, std::string_view source);
    // What from_bytes() had no place for, each once, sorted: "door.swing", "torch". For one line to the user.
    const std::vector<std::string>& left_out() const { return left_out_; }

    static constexpr std::uint32_t kVersion = 2;

  private:
    struct Table {
        std::vector<Entity> entities;
        std::vector<SnapshotColumn> columns;  // by component id
    };
    struct Merge;

    explicit Snapshot(const Registry& registry) : registry_(&registry) {}
    static const ComponentType& declared(const Registry& registry, const ComponentInfo& info, Entity e);
    void fill(World& world, const Table& table, Merge& merge) const;
    void restore_resources(World& world) const;
    class Reading;
    bool was_stored(const ComponentType& type) const;

    const Registry* registry_;
    bool stored_ = false;  // it comes from bytes: what is opaque is missing
    EntityTable::Numbers numbers_;
    std::vector<Table> tables_;
    // As Registry::resources(). Nothing: not stored, the world keeps its own; null: the world had none.
    std::vector<std::optional<std::shared_ptr<void>>> resources_;

    // Of those that come from bytes. What has been declared since: whole components, and fields by component.
    std::vector<const ComponentType*> new_types_;
    std::map<const ComponentType*, std::vector<const Field*>> new_fields_;
    std::vector<std::string> left_out_;
};

}  // namespace lanthorn::ecs
