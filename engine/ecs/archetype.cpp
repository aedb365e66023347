#include "lanthorn/ecs/archetype.h"

#include <algorithm>
#include <new>

#include "lanthorn/ecs/error.h"

namespace lanthorn::ecs {
namespace {

constexpr std::size_t round_up(std::size_t n, std::size_t to) {
    return (n + to - 1) / to * to;
}

void copy_bytes(void* to, const void* from, std::size_t n) {
    // The common sizes as constants, so that they become a few moves instead of a call.
    switch (n) {
        case 1:
            std::memcpy(to, from, 1);
            break;
        case 4:
            std::memcpy(to, from, 4);
            break;
        case 8:
            std::memcpy(to, from, 8);
            break;
        case 12:
            std::memcpy(to, from, 12);
            break;
        case 16:
            std::memcpy(to, from, 16);
            break;
        case 64:
            std::memcpy(to, from, 64);
            break;
        default:
            std::memcpy(to, from, n);
    }
}

}  // namespace

std::byte* ChunkPool::take(std::size_t bytes, std::size_t align) {
    if (bytes == kChunkBytes && align == kAlign) {
        if (free_.empty()) {
            std::byte* chunk = memory_.take();
            if (free_.capacity() < ++taken_) {
                free_.reserve(2 * taken_);  // so that give() cannot throw
            }
            return chunk;
        }
        std::byte* chunk = free_.back();
        free_.pop_back();
        return chunk;
    }
    return static_cast<std::byte*>(::operator new (bytes, std::align_val_t{align}));
}

std::uint32_t ChunkPool::enlist(const Chunk& chunk, std::uint32_t first_row) {
    if (!free_numbers_.empty()) {
        const std::uint32_t number = free_numbers_.back();
        free_numbers_.pop_back();
        chunks_[number] = chunk;
        first_rows_[number] = first_row;
        return number;
    }
    if (chunks_.size() >= kMostChunks) {
        throw Error("out of memory for components: 2^19 chunks of 64 KiB or more are in use");
    }
    if (free_numbers_.capacity() <= chunks_.size()) {
        const std::size_t more = 2 * (chunks_.size() + 1);
        chunks_.reserve(more);
        first_rows_.reserve(more);
        free_numbers_.reserve(more);  // so that strike() cannot throw
    }
    first_rows_.push_back(first_row);
    chunks_.push_back(chunk);
    return static_cast<std::uint32_t>(chunks_.size() - 1);
}

void ChunkPool::give(std::byte* chunk, std::size_t bytes, std::size_t align) noexcept {
    if (bytes == kChunkBytes && align == kAlign) {
        if (free_.size() >= kKept) {
            memory_.discard(chunk);
        }
        free_.push_back(chunk);
    } else {
        ::operator delete (chunk, std::align_val_t{align});
    }
}

Archetype::Archetype(std::vector<const ComponentInfo*> components, ChunkPool& pool)
    : components_(std::move(components)), pool_(&pool), chunk_align_(ChunkPool::kAlign) {
    std::size_t row_bytes = sizeof(Entity);
    std::size_t overhead = ChunkPool::kAlign;
    for (const ComponentInfo* info : components_) {
        row_bytes += info->size + 2 * sizeof(RowTick);
        chunk_align_ = std::max(chunk_align_, info->align);
        overhead += sizeof(ChunkTicks) + 2 * ChunkPool::kAlign + std::max(info->align, ChunkPool::kAlign);
        trivial_ = trivial_ && info->trivial;
    }
    std::size_t rows = 8;
    while (rows * 2 * row_bytes + overhead <= ChunkPool::kChunkBytes) {
        rows *= 2;
    }
    static_assert(ChunkPool::kMostRows * 2 * sizeof(Entity) >= ChunkPool::kChunkBytes);
    row_shift_ = static_cast<std::uint32_t>(std::countr_zero(rows));
    row_mask_ = static_cast<std::uint32_t>(rows - 1);

    std::size_t at = rows * sizeof(Entity);
    for (const ComponentInfo* info : components_) {
        Column c{info, static_cast<std::uint32_t>(info->size), info->trivial, 0, 0, 0, 0};
        at = round_up(at, std::max(info->align, ChunkPool::kAlign));
        c.data = static_cast<std::uint32_t>(at);
        at += rows * info->size;
        columns_.push_back(c);
        if (info->id >= column_of_.size()) {
            column_of_.resize(info->id + 1, kNoColumn);
        }
        column_of_[info->id] = static_cast<std::int16_t>(columns_.size() - 1);
    }
    ids_ = static_cast<std::uint32_t>(column_of_.size());
    data_of_ = std::make_unique<std::uint32_t[]>(ids_);
    for (Column& c : columns_) {
        data_of_[c.info->id] = c.data;
        at = round_up(at, alignof(ChunkTicks));
        c.ticks = static_cast<std::uint32_t>(at);
        at += sizeof(ChunkTicks);
        c.changed = static_cast<std::uint32_t>(at);
        at += rows * sizeof(RowTick);
        c.added = static_cast<std::uint32_t>(at);
        at += rows * sizeof(RowTick);
    }
    if (at > 0xffffffffu) {
        throw Error("components too large for a table: " + describe());
    }
    chunk_bytes_ = std::max(at, ChunkPool::kChunkBytes);
}

Archetype::~Archetype() {
    clear();
    while (!chunks_.empty()) {
        give_last();
    }
}

std::string Archetype::describe() const {
    std::string text = "[";
    for (const ComponentInfo* info : components_) {
        if (text.size() > 1) {
            text += ", ";
        }
        text += info->name;
    }
    return text + "]";
}

void Archetype::grow() {
    const std::size_t count = chunks_.size();
    if (chunks_.capacity() == count || numbers_.capacity() == count) {
        chunks_.reserve(2 * count + 1);
        numbers_.reserve(2 * count + 1);
    }
    std::byte* chunk = pool_->take(chunk_bytes_, chunk_align_);
    try {
        numbers_.push_back(pool_->enlist({chunk, this}, static_cast<std::uint32_t>(count << row_shift_)));
    } catch (...) {
        pool_->give(chunk, chunk_bytes_, chunk_align_);
        throw;
    }
    chunks_.push_back(chunk);
    for (const Column& c : columns_) {
        ::new (chunk + c.ticks) ChunkTicks{};
    }
}

void Archetype::reserve(std::uint32_t more) {
    while (chunks_.size() << row_shift_ < std::size_t{size_} + more) {
        grow();
    }
}

std::uint32_t Archetype::push_raw(Entity e) {
    if (size_ == chunks_.size() << row_shift_) {
        grow();
    }
    const std::uint32_t row = size_++;
    entity(row) = e;
    if (in_chunk(row) == 0) {
        std::byte* chunk = chunk_of(row);
        for (const Column& c : columns_) {
            ticks(chunk, c) = {};
        }
    }
    return row;
}

std::uint32_t Archetype::push(Entity e, RowTick now) {
    const std::uint32_t row = push_raw(e);
    std::byte* chunk = chunk_of(row);
    const std::uint32_t i = in_chunk(row);
    for (const Column& c : columns_) {
        changed(chunk, c)[i] = now;
        added(chunk, c)[i] = now;
        ChunkTicks& t = ticks(chunk, c);
        t.max_changed = now;
        t.max_added = now;
    }
    return row;
}

void Archetype::write_out_bulk(std::uint32_t row, const Column& c) {
    std::byte* chunk = chunk_of(row);
    ChunkTicks& t = ticks(chunk, c);
    RowTick* rows = changed(chunk, c);
    const std::uint32_t count = chunk_rows(row >> row_shift_);
    for (std::uint32_t i = 0; i < count; ++i) {
        rows[i] = std::max(rows[i], t.bulk_changed);
    }
    t.bulk_changed = 0;
}

Entity Archetype::remove(std::uint32_t row, bool destroy) {
    const std::uint32_t last = size_ - 1;
    if (destroy && !trivial_) {
        for (int c = 0; c < static_cast<int>(columns_.size()); ++c) {
            const ComponentInfo& info = *columns_[static_cast<std::size_t>(c)].info;
            if (!info.trivial) {
                info.destroy(data(row, c));
            }
        }
    }
    Entity moved = kNullEntity;
    if (row != last) {
        moved = entity(last);
        entity(row) = moved;
        std::byte* from = chunk_of(last);
        std::byte* to = chunk_of(row);
        const std::uint32_t i = in_chunk(last);
        const std::uint32_t j = in_chunk(row);
        for (const Column& c : columns_) {
            void* source = from + c.data + std::size_t{c.size} * i;
            void* target = to + c.data + std::size_t{c.size} * j;
            if (c.trivial) {
                copy_bytes(target, source, c.size);
            } else {
                c.info->relocate(target, source);
            }
            if (from == to) {
                changed(to, c)[j] = changed(from, c)[i];
                added(to, c)[j] = added(from, c)[i];
            } else {
                set_ticks(row, c, added(from, c)[i],
                          std::max(changed(from, c)[i], ticks(from, c).bulk_changed));
            }
        }
    }
    --size_;
    if (in_chunk(size_) == 0) {
        shrink();
    }
    return moved;
}

void Archetype::shrink() noexcept {
    const std::size_t needed = (std::size_t{size_} + row_mask_) >> row_shift_;
    while (chunks_.size() > needed + 1) {  // one spare: no thrashing at a chunk's border
        give_last();
    }
}

void Archetype::give_last() noexcept {
    pool_->strike(numbers_.back());
    pool_->give(chunks_.back(), chunk_bytes_, chunk_align_);
    numbers_.pop_back();
    chunks_.pop_back();
}

void Archetype::clear() noexcept {
    if (!trivial_) {
        for (std::uint32_t row = 0; row < size_; ++row) {
            for (int c = 0; c < static_cast<int>(columns_.size()); ++c) {
                const ComponentInfo& info = *columns_[static_cast<std::size_t>(c)].info;
                if (!info.trivial) {
                    info.destroy(data(row, c));
                }
            }
        }
    }
    size_ = 0;
    shrink();
}

void Archetype::rebase(RowTick delta) {
    const auto less = [delta](RowTick& t) { t = t > delta ? t - delta : 0; };
    for (std::uint32_t i = 0; i < chunk_count(); ++i) {
        for (const Column& c : columns_) {
            for (std::uint32_t row = 0; row < chunk_rows(i); ++row) {
                less(changed(chunks_[i], c)[row]);
                less(added(chunks_[i], c)[row]);
            }
            ChunkTicks& t = ticks(chunks_[i], c);
            less(t.bulk_changed);
            less(t.max_changed);
            less(t.max_added);
        }
    }
}

}  // namespace lanthorn::ecs
