#include "lanthorn/ecs/commands.h"

#include <algorithm>
#include <cstdint>

namespace lanthorn::ecs {

void* Commands::allocate(std::size_t size, std::size_t align) {
    constexpr std::size_t block_bytes = 16 * 1024;
    for (;; ++block_, used_ = 0) {
        if (block_ == blocks_.size()) {
            const std::size_t bytes = std::max(block_bytes, size + align);
            blocks_.push_back({std::make_unique_for_overwrite<std::byte[]>(bytes), bytes});
        }
        const Block& block = blocks_[block_];
        const auto start = reinterpret_cast<std::uintptr_t>(block.bytes.get());
        const std::size_t at = (start + used_ + align - 1) / align * align - start;
        if (at + size <= block.size) {
            used_ = at + size;
            return block.bytes.get() + at;
        }
    }
}

Entity Commands::reserve() {
    detail::check_not_in_parallel_each("give commands");
    if (!parallel_) {
        return world_->entities().reserve();
    }
    ++taken_;
    if (pool_next_ < pool_.size()) {
        return pool_[pool_next_++];
    }
    return EntityTable::reserve_in_parallel(base_, slot_, slots_, overflow_++);
}

void Commands::fill_pool() {
    while (pool_.size() < pool_target_) {
        pool_.push_back(world_->entities().reserve());
    }
}

void Commands::begin_parallel(std::uint32_t base, std::uint32_t slot, std::uint32_t slots) {
    parallel_ = true;
    base_ = base;
    slot_ = slot;
    slots_ = slots;
    overflow_ = 0;
    taken_ = 0;
}

void Commands::end_parallel() {
    parallel_ = false;
    world_->entities().adopt(base_, slot_, slots_, overflow_);
    overflow_ = 0;
    pool_target_ = std::max({taken_, pool_target_ - pool_target_ / 16, std::size_t{16}});
    return_pool();
}

void Commands::return_pool() noexcept {
    while (pool_.size() > pool_next_) {
        world_->entities().cancel(pool_.back());
        pool_.pop_back();
    }
    pool_.clear();
    pool_next_ = 0;
}

void Commands::apply() {
    world_->check_unlocked("apply commands");
    // Commands given while these run (by run()) follow in the same pass.
    try {
        for (std::size_t i = 0; i < ops_.size(); ++i) {
            const Op op = ops_[i];
            ops_[i].drop = [](void*) noexcept {};
            struct Drop {
                const Op& op;
                ~Drop() { op.drop(op.payload); }
            } drop{op};
            op.run(op.payload, *world_);
        }
    } catch (...) {
        discard();
        throw;
    }
    created_.clear();
    forget();
}

void Commands::discard() noexcept {
    if (parallel_) {
        end_parallel();
    }
    for (const Op& op : ops_) {
        op.drop(op.payload);
    }
    for (const Entity e : created_) {
        if (world_->entities().reserved(e)) {
            world_->entities().cancel(e);
        }
    }
    created_.clear();
    forget();
}

void Commands::forget() noexcept {
    ops_.clear();
    block_ = 0;
    used_ = 0;
}

}  // namespace lanthorn::ecs
