#include "lanthorn/ecs/entity_table.h"

#include <new>

#include "lanthorn/ecs/error.h"

namespace lanthorn::ecs {

EntityTable::Record* EntityTable::no_page() {
    static Record page[kPageSize];
    return page;
}

void EntityTable::make_page(std::uint32_t page) {
    if (page >= kMostPages) {
        throw Error("out of entities: 2^31 indices are in use");
    }
    if (page >= pages_.size()) {
        pages_.resize(page + 1, no_page());
        end_ = (page + 1) << kPageBits;
    }
    if (pages_[page] == no_page()) {
        pages_[page] = new (memory_.take()) Record[kPageSize];
    }
}

Entity EntityTable::reserve_fresh() {
    if ((next_ & (kPageSize - 1)) == 0) {
        // Pages that parallel systems took are skipped, those they left out are filled.
        while ((next_ >> kPageBits) < pages_.size() && pages_[next_ >> kPageBits] != no_page()) {
            next_ += kPageSize;
        }
        make_page(next_ >> kPageBits);
    }
    const std::uint32_t index = next_++;
    Record& r = record(index);
    r.place = kReserved;
    return {index, r.generation};
}

Entity EntityTable::reserve_in_parallel(std::uint32_t base, std::uint32_t slot, std::uint32_t slots,
                                        std::uint32_t k) {
    const std::uint64_t page = base + std::uint64_t{k >> kPageBits} * slots + slot;
    if (page >= kMostPages) {
        throw Error("out of entities: 2^31 indices are in use");
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
                r.place = kReserved;
            } else {
                r.place = free_head_;
                free_head_ = kNotAlive | (page << kPageBits) | i;
            }
        }
    }
}

bool EntityTable::reserved(Entity e) const {
    const Record* r = at(e.index);
    return r && r->generation == e.generation && r->place == kReserved;
}

EntityTable::Numbers EntityTable::numbers() const {
    Numbers numbers;
    numbers.next = next_;
    numbers.free_head = link_of(free_head_);
    for (std::uint32_t page = 0; page < pages_.size(); ++page) {
        if (pages_[page] == no_page()) {
            continue;
        }
        numbers.pages.push_back(page);
        for (std::uint32_t i = 0; i < kPageSize; ++i) {
            const Record& r = pages_[page][i];
            numbers.generations.push_back(r.generation);
            numbers.links.push_back(r.alive() ? 0 : link_of(r.place));
        }
    }
    return numbers;
}

void EntityTable::restore(const Numbers& numbers) {
    pages_.clear();
    end_ = 0;
    memory_.clear();
    for (std::size_t k = 0; k < numbers.pages.size(); ++k) {
        make_page(numbers.pages[k]);
        for (std::uint32_t i = 0; i < kPageSize; ++i) {
            pages_[numbers.pages[k]][i] = {numbers.generations[k * kPageSize + i],
                                           kNotAlive | numbers.links[k * kPageSize + i]};
        }
    }
    next_ = numbers.next;
    free_head_ = kNotAlive | numbers.free_head;
}

}  // namespace lanthorn::ecs
