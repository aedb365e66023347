// One table: all entities with exactly the same set of components, in chunks of about 64 KiB whose columns
// are plain arrays.
//
// Every row remembers when each of its components was added and last written. Writing a whole chunk costs one
// store (ChunkTicks::bulk_changed): a row's tick of change is the larger of its own and the chunk's.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
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

class Archetype;

// The chunks of all tables of a world. Recycles their memory, and numbers them: a place is the number of a
// chunk and a row in it, in 31 bits.
class ChunkPool {
  public:
    static constexpr std::size_t kChunkBytes = 64 * 1024;
    static constexpr std::size_t kAlign = 64;
    static constexpr std::uint32_t kRowBits = 12;  // of a place
    static constexpr std::uint32_t kMostRows = 1u << kRowBits;
    static constexpr std::uint32_t kMostChunks = 1u << (31 - kRowBits);  // 32 GiB

    // A block of memory that holds rows of one table.
    struct Chunk {
        std::byte* memory = nullptr;
        Archetype* archetype = nullptr;  // whose it is
    };

    // Memory for a chunk. Throws std::bad_alloc.
    std::byte* take(std::size_t bytes, std::size_t align);
    // Takes back what take() gave for the same `bytes` and `align`. Up to 512 free chunks of the usual size
    // keep their pages, the rest go to the system.
    void give(std::byte* chunk, std::size_t bytes, std::size_t align) noexcept;

    // The chunk's number from now on; its first row is `first_row` of its table. Throws an Error if there
    // are kMostChunks.
    std::uint32_t enlist(const Chunk& chunk, std::uint32_t first_row);
    // The number is free again, for the next enlist().
    void strike(std::uint32_t number) noexcept { free_numbers_.push_back(number); }

    // The chunk that a place is in. O(1).
    const Chunk& chunk_at(std::uint32_t place) const { return chunks_[place >> kRowBits]; }
    // The row of a place, counted from its chunk's first.
    static std::uint32_t in_chunk(std::uint32_t place) { return place & (kMostRows - 1); }
    // In the table.
    std::uint32_t row_at(std::uint32_t place) const {
        return first_rows_[place >> kRowBits] + in_chunk(place);
    }

  private:
    static constexpr std::size_t kKept =
        512;  // at most 32 MiB; of more than these the system gets the pages back
    BlockMemory memory_{kChunkBytes};
    std::vector<std::byte*> free_;
    std::size_t taken_ = 0;  // chunks from memory_
    std::vector<Chunk> chunks_;
    std::vector<std::uint32_t> first_rows_;
    std::vector<std::uint32_t> free_numbers_;
};

class Archetype {
  public:
    static constexpr int kNoColumn = -1;

    // Where a component's arrays lie in every chunk of the table.
    struct Column {
        const ComponentInfo* info;
        std::uint32_t size;  // as info has it, and the next: read once a row and column
        bool trivial;
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

    std::uint32_t size() const { return size_; }  // rows, over all chunks
    const std::vector<const ComponentInfo*>& components() const { return components_; }  // sorted by id
    // One a component, in the order of components().
    const std::vector<Column>& columns() const { return columns_; }
    // The component's place in columns(); kNoColumn if the table lacks it. O(1).
    int column(TypeId id) const { return id < column_of_.size() ? column_of_[id] : kNoColumn; }
    bool has(TypeId id) const { return column(id) != kNoColumn; }  // O(1)
    // Where the component's values begin in a chunk, in bytes; 0 if the table lacks it.
    std::uint32_t data_offset(TypeId id) const { return id < ids_ ? data_of_[id] : 0; }
    std::string describe() const;  // "[A, B]"

    // One of the components has hooks; World's to set.
    bool hooked = false;

    // Chunks. All but the last are full.
    std::uint32_t chunk_count() const { return (size_ + row_mask_) >> row_shift_; }
    std::uint32_t rows_per_chunk() const { return row_mask_ + 1; }  // a power of two
    // Rows in use of chunk `chunk`, which must be below chunk_count().
    std::uint32_t chunk_rows(std::uint32_t chunk) const {
        const std::uint32_t first = chunk << row_shift_;
        return size_ - first > row_mask_ ? row_mask_ + 1 : size_ - first;
    }
    std::byte* chunk(std::uint32_t i) const { return chunks_[i]; }  // chunk `i`'s memory
    // The memory of the chunk that holds the row.
    std::byte* chunk_of(std::uint32_t row) const { return chunks_[row >> row_shift_]; }
    // The row's number within its chunk.
    std::uint32_t in_chunk(std::uint32_t row) const { return row & row_mask_; }
    // ChunkPool's.
    std::uint32_t place(std::uint32_t row) const {
        return numbers_[row >> row_shift_] << ChunkPool::kRowBits | in_chunk(row);
    }

    // The entities of a chunk's rows, which lie at its beginning.
    static Entity* entities(std::byte* chunk) { return reinterpret_cast<Entity*>(chunk); }
    // The entity that the row belongs to.
    Entity& entity(std::uint32_t row) const { return entities(chunk_of(row))[in_chunk(row)]; }
    // The component's value in the row; `column` as column() gave it.
    void* data(std::uint32_t row, int column) const {
        const Column& c = columns_[static_cast<std::size_t>(column)];
        return chunk_of(row) + c.data + std::size_t{c.size} * in_chunk(row);
    }
    // When each row of a chunk was written last, bulk writes aside: ChunkTicks::bulk_changed counts too.
    static RowTick* changed(std::byte* chunk, const Column& c) {
        return reinterpret_cast<RowTick*>(chunk + c.changed);
    }
    // When each row of a chunk got the component.
    static RowTick* added(std::byte* chunk, const Column& c) {
        return reinterpret_cast<RowTick*>(chunk + c.added);
    }
    // What holds for the chunk's rows together.
    static ChunkTicks& ticks(std::byte* chunk, const Column& c) {
        return *reinterpret_cast<ChunkTicks*>(chunk + c.ticks);
    }
    // When the row's component was written last, bulk writes included.
    RowTick changed_tick(std::uint32_t row, int column) const {
        const Column& c = columns_[static_cast<std::size_t>(column)];
        std::byte* chunk = chunk_of(row);
        return std::max(changed(chunk, c)[in_chunk(row)], ticks(chunk, c).bulk_changed);
    }
    // When the row got the component.
    RowTick added_tick(std::uint32_t row, int column) const {
        return added(chunk_of(row), columns_[static_cast<std::size_t>(column)])[in_chunk(row)];
    }
    // Notes that the row's component was written at `now`.
    void mark_changed(std::uint32_t row, int column, RowTick now) {
        mark_changed_in(chunk_of(row), in_chunk(row), column, now);
    }
    // The same for row `in_chunk` of a chunk at hand, without looking it up.
    void mark_changed_in(std::byte* chunk, std::uint32_t in_chunk, int column, RowTick now) const {
        const Column& c = columns_[static_cast<std::size_t>(column)];
        changed(chunk, c)[in_chunk] = now;
        ChunkTicks& t = ticks(chunk, c);
        t.max_changed = std::max(t.max_changed, now);
    }

    // A new last row of `e`, its components' memory raw; every one must be constructed next. Ticks are `now`.
    std::uint32_t push(Entity e, RowTick now);
    // Like push, for a row that arrives from another table: ticks are not set.
    std::uint32_t push_raw(Entity e);
    // Makes room for `more` rows.
    void reserve(std::uint32_t more);
    // Dates the row, as one that comes from another table. O(rows of the chunk) where the chunk was written
    // in bulk after `changed_at`.
    void set_ticks(std::uint32_t row, int column, RowTick added_at, RowTick changed_at) {
        set_ticks(row, columns_[static_cast<std::size_t>(column)], added_at, changed_at);
    }
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
    void set_ticks(std::uint32_t row, const Column& c, RowTick added_at, RowTick changed_at) {
        std::byte* chunk = chunk_of(row);
        ChunkTicks& t = ticks(chunk, c);
        if (t.bulk_changed > changed_at) {
            write_out_bulk(row, c);
        }
        changed(chunk, c)[in_chunk(row)] = changed_at;
        added(chunk, c)[in_chunk(row)] = added_at;
        t.max_changed = std::max(t.max_changed, changed_at);
        t.max_added = std::max(t.max_added, added_at);
    }
    // Of the row's chunk, to all rows: for one that was no part of the bulk write.
    void write_out_bulk(std::uint32_t row, const Column& c);
    void shrink() noexcept;
    void give_last() noexcept;

    std::vector<const ComponentInfo*> components_;
    std::vector<Column> columns_;
    std::vector<std::int16_t> column_of_;
    std::unique_ptr<std::uint32_t[]> data_of_;  // by component id
    std::uint32_t ids_ = 0;                     // how many
    ChunkPool* pool_;
    std::vector<std::byte*> chunks_;      // may be one more than needed
    std::vector<std::uint32_t> numbers_;  // theirs
    std::size_t chunk_bytes_ = 0;
    std::size_t chunk_align_ = 0;
    std::uint32_t size_ = 0;
    std::uint32_t row_shift_ = 0;
    std::uint32_t row_mask_ = 0;
    bool trivial_ = true;
};

}  // namespace lanthorn::ecs
