// Which entities exist and where their components are. Indices are reused, last freed first.
//
// A record is 8 bytes, so that access in random order misses the cache as seldom as can be (bench_ecs:
// random_get). That leaves 31 bits for a place and as many for an index.
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

class EntityTable {
  public:
    static constexpr std::uint32_t kNotAlive = 0x80000000u;

    // Of an index: which entity has it, and where that is.
    struct Record {
        std::uint32_t generation = 1;
        // Of a living entity a place (ChunkPool); else kNotAlive and the next free index, or one of the marks
        // below.
        std::uint32_t place = kNotAlive;

        bool alive() const { return place < kNotAlive; }  // of the index's present generation
    };

    static constexpr std::uint32_t kPageBits = 10;
    static constexpr std::uint32_t kPageSize = 1u << kPageBits;

    // A new number for an entity that is not alive until its record gets a place.
    Entity reserve() {
        if (free_head_ != kEnd) {
            const std::uint32_t index = free_head_ & ~kNotAlive;
            Record& r = record(index);
            free_head_ = r.place;
            r.place = kReserved;
            return {index, r.generation};
        }
        return reserve_fresh();
    }

    // Numbers for many who reserve at once, each a slot of `slots`, counting k from 0: no table is touched.
    // `base` is first_parallel_page(), which must not change until all have called adopt() with the count
    // they took.
    static Entity reserve_in_parallel(std::uint32_t base, std::uint32_t slot, std::uint32_t slots,
                                      std::uint32_t k);
    // Makes records for the first `count` numbers that the slot reserved; the rest of their last page are
    // free. Slots one after another, in their order.
    void adopt(std::uint32_t base, std::uint32_t slot, std::uint32_t slots, std::uint32_t count);
    // The page behind the last there is.
    std::uint32_t first_parallel_page() const { return static_cast<std::uint32_t>(pages_.size()); }

    // Gives back a reserved number that never came alive.
    void cancel(Entity e) {
        record(e.index).place = free_head_;
        free_head_ = kNotAlive | e.index;
    }
    // Gives a number back; handles to it are stale from now on. A generation that would overflow retires its
    // index.
    void release(Entity e) {
        Record& r = record(e.index);
        if (++r.generation == 0) {
            r.generation = 0xffffffffu;
            r.place = kRetired;
            return;
        }
        r.place = free_head_;
        free_head_ = kNotAlive | e.index;
    }

    // Null for a dead, reserved or null entity.
    Record* find(Entity e) {
        Record* r = at(e.index);
        return r && r->generation == e.generation && r->alive() ? r : nullptr;
    }
    // The same to read.
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
    // O(indices that were ever given out).
    Numbers numbers() const;
    // Nothing is alive afterwards; records get their places next.
    void restore(const Numbers& numbers);

    // Of an index that was given out, which is not checked.
    Record& record(std::uint32_t index) { return pages_[index >> kPageBits][index & (kPageSize - 1)]; }

  private:
    static constexpr std::uint32_t kEnd = 0xffffffffu;
    static constexpr std::uint32_t kReserved = 0xfffffffeu;
    static constexpr std::uint32_t kRetired = 0xfffffffdu;
    // A page less than 31 bits can number, so that no index looks like a mark.
    static constexpr std::uint32_t kMostPages = (1u << (31 - kPageBits)) - 1;

    Record* at(std::uint32_t index) const {
        return index < end_ ? &pages_[index >> kPageBits][index & (kPageSize - 1)] : nullptr;
    }
    static Record* no_page();  // of records that nobody gave out
    // As Numbers::links has it: a bare index, or a mark.
    static std::uint32_t link_of(std::uint32_t place) {
        return place >= kRetired ? place : place & ~kNotAlive;
    }
    Entity reserve_fresh();
    void make_page(std::uint32_t page);

    std::vector<Record*> pages_;  // no_page(): no index of that page was given out
    std::uint32_t end_ = 0;       // of the indices that pages_ covers
    BlockMemory memory_{kPageSize * sizeof(Record)};
    std::uint32_t next_ = 0;  // first index of the running page never given out
    std::uint32_t free_head_ = kEnd;
};

}  // namespace lanthorn::ecs
