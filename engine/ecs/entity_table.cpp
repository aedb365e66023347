#include "lanthorn/ecs/entity_table.h"

#include <new>

#include "lanthorn/ecs/error.h"

namespace lanthorn::ecs {

void EntityTable::make_page(std::uint32_t page) {
    if (page >= (1u << (32 - kPageBits)) - 1) {
        throw Error("out of entities: 2^32 indices are in use");
    }
    if (page >= pages_.size()) {
        pages_.resize(page + 1);
    }
    if (!pages_[page]) {
        pages_[page] = new (memory_.take()) Record[kPageSize];
    }
}

Entity EntityTable::reserve_fresh() {
    if ((next_ & (kPageSize - 1)) == 0) {
        // Pages that parallel systems took are skipped, those they left out are filled.
        while ((next_ >> kPageBits) < pages_.size() && pages_[next_ >> kPageBits]) {
            next_ += kPageSize;
        }
        make_page(next_ >> kPageBits);
    }
    const std::uint32_t index = next_++;
    Record& r = record(index);
    r.row = kReserved;
    return {index, r.generation};
}

Entity EntityTable::reserve_in_parallel(std::uint32_t base, std::uint32_t slot, std::uint32_t slots,
                                        std::uint32_t k) {
    const std::uint64_t page = base + std::uint64_t{k >> kPageBits} * slots + slot;
    if (page >= (1u << (32 - kPageBits)) - 1) {
        throw Error("out of entities: 2^32 indices are in use");
    }
    return {static_cast<std::uint32_t>(page << kPageBits) | (k & (kPageSize - 1)), 1};
}

void EntityTable::adopt(std::uint32_t base, std::uint32_t slot, std::uint32_t slots, std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; k += kPageSize) {
        const std::uint32_t page = base + (k >> kPageBits) * slots + slot;
        make_page(page);
        for (std::uint32_t i = kPageSize; i-- > 0;) {
            Record& r = pages_[page][i];
            if (k + i < count) {
                r.row = kReserved;
            } else {
                r.row = free_head_;
                free_head_ = (page << kPageBits) | i;
            }
        }
    }
}

bool EntityTable::reserved(Entity e) const {
    const Record* r = at(e.index);
    return r && r->generation == e.generation && !r->archetype && r->row == kReserved;
}

EntityTable::Numbers EntityTable::numbers() const {
    Numbers numbers;
    numbers.next = next_;
    numbers.free_head = free_head_;
    for (std::uint32_t page = 0; page < pages_.size(); ++page) {
        if (!pages_[page]) {
            continue;
        }
        numbers.pages.push_back(page);
        for (std::uint32_t i = 0; i < kPageSize; ++i) {
            const Record& r = pages_[page][i];
            numbers.generations.push_back(r.generation);
            numbers.links.push_back(r.archetype ? 0 : r.row);
        }
    }
    return numbers;
}

void EntityTable::restore(const Numbers& numbers) {
    pages_.clear();
    memory_.clear();
    for (std::size_t k = 0; k < numbers.pages.size(); ++k) {
        make_page(numbers.pages[k]);
        for (std::uint32_t i = 0; i < kPageSize; ++i) {
            pages_[numbers.pages[k]][i] = {nullptr, numbers.links[k * kPageSize + i],
                                           numbers.generations[k * kPageSize + i]};
        }
    }
    next_ = numbers.next;
    free_head_ = numbers.free_head;
}

}  // namespace lanthorn::ecs
