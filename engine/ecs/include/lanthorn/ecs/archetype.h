// One table: all entities with exactly the same set of components, in chunks of about 64 KiB whose columns
// are plain arrays.
//
// Every row remembers when each of its components was added and last written. Writing a whole chunk costs one
// store (ChunkTicks::bulk_changed): a row's tick of change is the larger of its own and the chunk's.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/ecs/block_memory.h"
#include "lanthorn/ecs/entity.h"
#include "lanthorn/ecs/type_info.h"

namespace lanthorn::ecs {

// A tick as rows store it: relative to World's tick base.
using RowTick = std::uint32_t;

// Kept per chunk and column.
struct ChunkTicks {
    RowTick bulk_changed = 0;  // all rows were written then
    RowTick max_changed = 0;   // no row was written later
    RowTick max_added = 0;
};

// Recycles chunk memory between tables.
class ChunkPool {
  public:
    static constexpr std::size_t kChunkBytes = 64 * 1024;
    static constexpr std::size_t kAlign = 64;

    std::byte* take(std::size_t bytes, std::size_t align);
    void give(std::byte* chunk, std::size_t bytes, std::size_t align) noexcept;

  private:
    static constexpr std::size_t kKept =
        512;  // at most 32 MiB; of more than these the system gets the pages back
    BlockMemory memory_{kChunkBytes};
    std::vector<std::byte*> free_;
    std::size_t taken_ = 0;  // chunks from memory_
};

class Archetype {
  public:
    static constexpr int kNoColumn = -1;

    struct Column {
        const ComponentInfo* info;
        std::uint32_t data;     // byte offsets in a chunk
        std::uint32_t changed;  // RowTick per row
        std::uint32_t added;    // RowTick per row
        std::uint32_t ticks;    // ChunkTicks
    };

    // `components` sorted by id, without repetition.
    Archetype(std::vector<const ComponentInfo*> components, ChunkPool& pool);
    Archetype(const Archetype&) = delete;
    Archetype& operator=(const Archetype&) = delete;
    ~Archetype();

    std::uint32_t size() const { return size_; }
    const std::vector<const ComponentInfo*>& components() const { return components_; }
    const std::vector<Column>& columns() const { return columns_; }
    int column(TypeId id) const { return id < column_of_.size() ? column_of_[id] : kNoColumn; }
    bool has(TypeId id) const { return column(id) != kNoColumn; }
    std::string describe() const;  // "[A, B]"

    // One of the components has hooks; World's to set.
    bool hooked = false;

    // Chunks. All but the last are full.
    std::uint32_t chunk_count() const { return (size_ + row_mask_) >> row_shift_; }
    std::uint32_t rows_per_chunk() const { return row_mask_ + 1; }
    std::uint32_t chunk_rows(std::uint32_t chunk) const {
        const std::uint32_t first = chunk << row_shift_;
        return size_ - first > row_mask_ ? row_mask_ + 1 : size_ - first;
    }
    std::byte* chunk(std::uint32_t i) const { return chunks_[i]; }
    std::byte* chunk_of(std::uint32_t row) const { return chunks_[row >> row_shift_]; }
    std::uint32_t in_chunk(std::uint32_t row) const { return row & row_mask_; }

    static Entity* entities(std::byte* chunk) { return reinterpret_cast<Entity*>(chunk); }
    Entity& entity(std::uint32_t row) const { return entities(chunk_of(row))[in_chunk(row)]; }
    void* data(std::uint32_t row, int column) const {
        const Column& c = columns_[static_cast<std::size_t>(column)];
        return chunk_of(row) + c.data + c.info->size * in_chunk(row);
    }
    static RowTick* changed(std::byte* chunk, const Column& c) {
        return reinterpret_cast<RowTick*>(chunk + c.changed);
    }
    static RowTick* added(std::byte* chunk, const Column& c) {
        return reinterpret_cast<RowTick*>(chunk + c.added);
    }
    static ChunkTicks& ticks(std::byte* chunk, const Column& c) {
        return *reinterpret_cast<ChunkTicks*>(chunk + c.ticks);
    }
    RowTick changed_tick(std::uint32_t row, int column) const;
    RowTick added_tick(std::uint32_t row, int column) const;
    void mark_changed(std::uint32_t row, int column, RowTick now);

    // A new last row of `e`, its components' memory raw; every one must be constructed next. Ticks are `now`.
    std::uint32_t push(Entity e, RowTick now);
    // Like push, for a row that arrives from another table: ticks are not set.
    std::uint32_t push_raw(Entity e);
    // Makes room for `more` rows.
    void reserve(std::uint32_t more);
    void set_ticks(std::uint32_t row, int column, RowTick added, RowTick changed);
    // Destroys the row's components (if `destroy`, else they were moved out) and fills the hole with the last
    // row. Returns the entity that is now at `row`, or the null entity if none.
    Entity remove(std::uint32_t row, bool destroy);
    // Destroys everything.
    void clear() noexcept;
    // All row ticks lose `delta`, not below 0.
    void rebase(RowTick delta);

    // Tables one component away, as World found them; indexed by component id.
    std::vector<Archetype*> with_edges, without_edges;

  private:
    void grow();
    void shrink() noexcept;

    std::vector<const ComponentInfo*> components_;
    std::vector<Column> columns_;
    std::vector<std::int16_t> column_of_;
    ChunkPool* pool_;
    std::vector<std::byte*> chunks_;  // may be one more than needed
    std::size_t chunk_bytes_ = 0;
    std::size_t chunk_align_ = 0;
    std::uint32_t size_ = 0;
    std::uint32_t row_shift_ = 0;
    std::uint32_t row_mask_ = 0;
    bool trivial_ = true;
};

}  // namespace lanthorn::ecs
