// Which entities exist and where their components are. Indices are reused, last freed first.
//
// Records lie in pages, so that deferred commands of parallel systems can number new entities without asking
// anyone (reserve_in_parallel): page numbers are dealt out by slot, which makes the numbers independent of
// timing.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/ecs/block_memory.h"
#include "lanthorn/ecs/entity.h"

namespace lanthorn::ecs {

class Archetype;

class EntityTable {
  public:
    struct Record {
        Archetype* archetype = nullptr;  // null: free, reserved or never used
        std::uint32_t row = 0;           // in the archetype; of a free record the next free index
        std::uint32_t generation = 1;
    };

    static constexpr std::uint32_t kPageBits = 10;
    static constexpr std::uint32_t kPageSize = 1u << kPageBits;

    // A new number for an entity that is not alive until its record gets an archetype.
    Entity reserve() {
        if (free_head_ != kEnd) {
            const std::uint32_t index = free_head_;
            Record& r = record(index);
            free_head_ = r.row;
            r.row = kReserved;
            return {index, r.generation};
        }
        return reserve_fresh();
    }

    // Numbers for many who reserve at once, each a slot of `slots`, counting k from 0: no table is touched.
    // `base` is first_parallel_page(), which must not change until all have called adopt() with the count
    // they took.
    static Entity reserve_in_parallel(std::uint32_t base, std::uint32_t slot, std::uint32_t slots,
                                      std::uint32_t k);
    void adopt(std::uint32_t base, std::uint32_t slot, std::uint32_t slots, std::uint32_t count);
    std::uint32_t first_parallel_page() const { return static_cast<std::uint32_t>(pages_.size()); }

    // Gives back a reserved number that never came alive.
    void cancel(Entity e) {
        record(e.index).row = free_head_;
        free_head_ = e.index;
    }
    // Gives a number back; handles to it are stale from now on. A generation that would overflow retires its
    // index.
    void release(Entity e) {
        Record& r = record(e.index);
        r.archetype = nullptr;
        if (++r.generation == 0) {
            r.generation = 0xffffffffu;
            r.row = kRetired;
            return;
        }
        r.row = free_head_;
        free_head_ = e.index;
    }

    // Null for a dead, reserved or null entity.
    Record* find(Entity e) {
        Record* r = at(e.index);
        return r && r->generation == e.generation && r->archetype ? r : nullptr;
    }
    const Record* find(Entity e) const { return const_cast<EntityTable*>(this)->find(e); }
    // Reserved and not yet created.
    bool reserved(Entity e) const;

    // Which numbers were given out, to go on from there: what snapshots keep of this table.
    struct Numbers {
        std::vector<std::uint32_t> generations, links;  // kPageSize a page; links are of free indices alone
        std::vector<std::uint32_t> pages;               // those there are, in order
        std::uint32_t next = 0;
        std::uint32_t free_head = 0;
    };
    Numbers numbers() const;
    // Nothing is alive afterwards; records get their archetypes next.
    void restore(const Numbers& numbers);

    Record& record(std::uint32_t index) { return pages_[index >> kPageBits][index & (kPageSize - 1)]; }

  private:
    static constexpr std::uint32_t kEnd = 0xffffffffu;
    static constexpr std::uint32_t kReserved = 0xfffffffeu;
    static constexpr std::uint32_t kRetired = 0xfffffffdu;

    Record* at(std::uint32_t index) const {
        const std::uint32_t page = index >> kPageBits;
        return page < pages_.size() && pages_[page] ? &pages_[page][index & (kPageSize - 1)] : nullptr;
    }
    Entity reserve_fresh();
    void make_page(std::uint32_t page);

    std::vector<Record*> pages_;  // null: no index of that page was given out
    BlockMemory memory_{kPageSize * sizeof(Record)};
    std::uint32_t next_ = 0;  // first index of the running page never given out
    std::uint32_t free_head_ = kEnd;
};

}  // namespace lanthorn::ecs
