#include "lanthorn/ecs/snapshot.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "engine/ecs/value_ops.h"
#include "lanthorn/ecs/component_json.h"

namespace lanthorn::ecs {

SnapshotColumn::SnapshotColumn(const ComponentType& type, std::size_t rows)
    : type_(&type),
      data_(static_cast<std::byte*>(::operator new (std::max<std::size_t>(rows* type.info->size, 1),
                                                    std::align_val_t{type.info->align}))) {}

SnapshotColumn::SnapshotColumn(SnapshotColumn&& other) noexcept
    : type_(other.type_), data_(std::exchange(other.data_, nullptr)), rows_(std::exchange(other.rows_, 0)) {}

SnapshotColumn::~SnapshotColumn() {
    if (!type_->info->trivial) {
        for (std::size_t i = 0; i < rows_; ++i) {
            type_->info->destroy(row(i));
        }
    }
    ::operator delete (data_, std::align_val_t{type_->info->align});
}

void SnapshotColumn::append(const void* values, std::size_t count) {
    const std::size_t size = type_->info->size;
    if (type_->info->trivial) {
        std::memcpy(row(rows_), values, count * size);
        rows_ += count;
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        type_->copy(row(rows_), at(values, i * size));
        ++rows_;
    }
}

const ComponentType& Snapshot::declared(const Registry& registry, const ComponentInfo& info, Entity e) {
    const ComponentType* type = registry.find(info.id);
    if (type == nullptr) {
        throw Error("snapshot: " + std::string(info.name) + " of " + to_string(e) +
                    " is not declared; declare it, as opaque_component() if nothing is to look into it");
    }
    return *type;
}

Snapshot Snapshot::save(const World& world, const Registry& registry) {
    Snapshot snapshot(registry);
    snapshot.numbers_ = world.entities().numbers();
    for (const auto& archetype : world.archetypes()) {
        if (archetype->size() == 0) {
            continue;
        }
        Table& table = snapshot.tables_.emplace_back();
        table.entities.reserve(archetype->size());
        table.columns.reserve(archetype->columns().size());
        for (const ComponentInfo* info : archetype->components()) {
            table.columns.emplace_back(declared(registry, *info, archetype->entity(0)), archetype->size());
        }
        for (std::uint32_t c = 0; c < archetype->chunk_count(); ++c) {
            std::byte* chunk = archetype->chunk(c);
            const std::uint32_t rows = archetype->chunk_rows(c);
            const Entity* entities = Archetype::entities(chunk);
            table.entities.insert(table.entities.end(), entities, entities + rows);
            for (std::size_t k = 0; k < table.columns.size(); ++k) {
                table.columns[k].append(chunk + archetype->columns()[k].data, rows);
            }
        }
    }
    for (const ResourceType& type : registry.resources()) {
        const void* value = type.get(world);
        snapshot.resources_.emplace_back(value != nullptr ? type.clone(value) : nullptr);
    }
    return snapshot;
}

std::size_t Snapshot::size() const {
    std::size_t count = 0;
    for (const Table& table : tables_) {
        count += table.entities.size();
    }
    return count;
}

bool Snapshot::was_stored(const ComponentType& type) const {
    return !type.opaque && std::ranges::find(new_types_, &type) == new_types_.end();
}

// What a column's rows get: when they were written last, and values that join what is stored with what is
// opaque or has been declared since, as it is in the present.
struct Snapshot::Merge {
    struct Column {
        std::vector<RowTick> added, changed;
        std::vector<std::shared_ptr<void>> values;  // empty, or one a row (null: the stored one)
    };
    std::vector<Column> columns;

    Merge(World& world, const Snapshot& snapshot, const Table& table, RowTick now)
        : columns(table.columns.size()) {
        const std::size_t rows = table.entities.size();
        for (Column& column : columns) {
            column.added.assign(rows, now);
            column.changed.assign(rows, now);
        }
        for (std::size_t i = 0; i < rows; ++i) {
            const World::Row row = world.row_of(table.entities[i]);
            if (!row) {
                continue;
            }
            for (std::size_t k = 0; k < columns.size(); ++k) {
                const ComponentType& type = table.columns[k].type();
                const int present = row.archetype->column(type.info->id);
                if (present != Archetype::kNoColumn) {
                    compare(columns[k], i, type, table.columns[k].row(i), row, present, snapshot);
                }
            }
        }
    }

  private:
    // What was not stored as it is in `now`, all else as it was saved.
    static std::shared_ptr<void> join(const ComponentType& type, const void* saved, const void* now,
                                      const std::vector<const Field*>& new_fields) {
        std::shared_ptr<void> joined = type.clone(now);
        for (const Field& field : type.value->fields) {
            if (std::ranges::find(new_fields, &field) == new_fields.end()) {
                std::string bytes;
                append_bytes(*field.type, at(saved, field.offset), Fields::all, bytes);
                std::span<const std::byte> rest = std::as_bytes(std::span(bytes));
                read_bytes(*field.type, at(joined.get(), field.offset), rest);
            }
        }
        return joined;
    }
    static void compare(Column& column, std::size_t i, const ComponentType& type, const void* saved,
                        const World::Row& row, int present, const Snapshot& snapshot) {
        const void* now = row.archetype->data(row.row, present);
        const auto newer = snapshot.new_fields_.find(&type);
        const bool has_newer = newer != snapshot.new_fields_.end();
        if (has_newer || (snapshot.stored_ && type.value->opaque_within)) {
            static const std::vector<const Field*> kNone;
            const std::shared_ptr<void> joined = join(type, saved, now, has_newer ? newer->second : kNone);
            column.values.resize(column.added.size());
            column.values[i] = joined;
            saved = joined.get();
        }
        column.added[i] = row.archetype->added_tick(row.row, present);
        const bool same = (type.info->trivial && std::memcmp(saved, now, type.info->size) == 0) ||
                          (!(type.opaque && type.info->trivial) && equal(*type.value, saved, now));
        if (same) {
            column.changed[i] = row.archetype->changed_tick(row.row, present);
        }
    }
};

void Snapshot::fill(World& world, const Table& table, Merge& merge) const {
    std::vector<const ComponentInfo*> infos;
    for (const SnapshotColumn& column : table.columns) {
        infos.push_back(column.type().info);
    }
    Archetype& archetype = world.archetype_of(std::move(infos));
    // Stored tables that differ by opaque components alone come to lie behind one another.
    const auto before = static_cast<std::uint32_t>(archetype.size());
    archetype.reserve(static_cast<std::uint32_t>(table.entities.size()));
    for (const Entity e : table.entities) {
        world.entities().record(e.index).place = archetype.place(archetype.push_raw(e));
    }
    world.alive_ += table.entities.size();
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        // Both are in the order of component ids.
        const ComponentType& type = table.columns[k].type();
        const int column = archetype.column(type.info->id);
        const Merge::Column& merged = merge.columns[k];
        for (std::uint32_t c = 0, first = 0; c < archetype.chunk_count(); ++c) {
            const std::uint32_t end = first + archetype.chunk_rows(c);
            const std::uint32_t begin = std::max(first, before);
            first = end;
            if (begin >= end) {
                continue;
            }
            void* values = archetype.data(begin, column);
            if (type.info->trivial && merged.values.empty()) {
                std::memcpy(values, table.columns[k].row(begin - before), (end - begin) * type.info->size);
            }
            for (std::uint32_t row = begin; row < end; ++row) {
                const std::uint32_t i = row - before;
                if (!type.info->trivial || !merged.values.empty()) {
                    const bool joined = !merged.values.empty() && merged.values[i] != nullptr;
                    type.copy(at(values, (row - begin) * type.info->size),
                              joined ? merged.values[i].get() : table.columns[k].row(i));
                }
                archetype.set_ticks(row, column, merged.added[i], merged.changed[i]);
            }
        }
    }
}

void Snapshot::restore_resources(World& world) const {
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        const ResourceType& type = registry_->resources()[i];
        if (!resources_[i]) {
            continue;
        }
        const void* const saved = resources_[i]->get();
        const void* present = type.get(world);
        if (saved == nullptr) {
            if (present != nullptr) {
                type.remove(world);
            }
        } else if (present == nullptr) {
            type.insert(world, saved);
        } else if (!equal(*type.value, present, saved)) {
            type.assign(type.get_mut(world), saved);
        }
    }
}

void Snapshot::restore(World& world) const {
    world.check_unlocked("restore a snapshot");
    std::vector<Merge> merges;
    merges.reserve(tables_.size());
    for (const Table& table : tables_) {
        merges.emplace_back(world, *this, table, world.row_tick(world.now()));
    }
    // What bytes could not hold, or had no name for, goes on where its entity does.
    struct Kept {
        Entity entity;
        const ComponentType* type;
        std::shared_ptr<void> value;
    };
    std::vector<Kept> kept;
    for (const Table& table : tables_) {
        for (std::size_t i = 0; stored_ && i < table.entities.size(); ++i) {
            if (!world.alive(table.entities[i])) {
                continue;
            }
            for (const ComponentType& type : registry_->components()) {
                const void* value = was_stored(type) ? nullptr : get(world, table.entities[i], type);
                if (value != nullptr) {
                    kept.push_back({table.entities[i], &type, type.clone(value)});
                }
            }
        }
    }
    for (const auto& archetype : world.archetypes()) {
        archetype->clear();
    }
    world.alive_ = 0;
    world.entities().restore(numbers_);
    for (std::size_t t = 0; t < tables_.size(); ++t) {
        fill(world, tables_[t], merges[t]);
    }
    for (const Kept& one : kept) {
        one.type->insert(world, one.entity, one.value.get());
    }
    restore_resources(world);
}

}  // namespace lanthorn::ecs
