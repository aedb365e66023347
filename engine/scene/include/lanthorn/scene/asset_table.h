// Assets of one kind by slot, each shared and never changed once it is in the table: a copy of the table
// copies pointers, and a copy keeps showing the assets as they were.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "lanthorn/scene/asset_handle.h"
#include "lanthorn/scene/asset_version.h"

namespace lanthorn {

// The assets of kind T (Mesh, Material, ...), by the slots that their handles name.
template <class T>
class AssetTable {
  public:
    AssetTable() = default;
    AssetTable(std::vector<T> values) {  // slots 0, 1, ... of generation 0
        slots_.reserve(values.size());
        for (T& value : values) {
            push_back(std::move(value));
        }
    }

    // Slots, free ones included. O(1).
    std::size_t size() const { return slots_.size(); }
    bool empty() const { return slots_.empty(); }  // no slot at all; free ones count
    // The slot holds an asset.
    bool has(std::size_t slot) const { return slot < slots_.size() && slots_[slot].value; }
    // The slot must hold an asset.
    const T& operator[](std::size_t slot) const {
        assert(has(slot));
        return *slots_[slot].value;
    }
    // Null of a free slot; the slot must exist.
    const std::shared_ptr<const T>& shared(std::size_t slot) const { return slots_[slot].value; }
    // The slot must exist.
    const AssetVersion<T>& version(std::size_t slot) const { return slots_[slot].version; }
    // The handle that names the slot's present asset.
    AssetHandle<T> handle(std::size_t slot) const {
        return {static_cast<std::uint32_t>(slot), slots_[slot].generation};
    }
    // Null for one that has been released or is of another table.
    const T* find(AssetHandle<T> handle) const {
        return handle.slot < slots_.size() && slots_[handle.slot].generation == handle.generation
                   ? slots_[handle.slot].value.get()
                   : nullptr;
    }

    // Building a table by hand; AssetStore does it for the assets of a world.
    AssetHandle<T> push_back(T value) {
        slots_.push_back(
            {std::make_shared<const T>(std::move(value)), 0, AssetVersion<T>(next_asset_version())});
        return handle(slots_.size() - 1);
    }
    // The same with T().
    AssetHandle<T> emplace_back() { return push_back(T()); }
    // Another asset in the place of the slot's; a slot past the end makes the table longer.
    void put(std::size_t slot, std::shared_ptr<const T> value, const AssetVersion<T>& version) {
        if (slot >= slots_.size()) {
            slots_.resize(slot + 1);
        }
        slots_[slot].value = std::move(value);
        slots_[slot].version = version;
    }
    // A copy altered by `alter`, which takes a T&: of another version in everything.
    template <class Alter>
    void edit(std::size_t slot, const Alter& alter) {
        auto altered = std::make_shared<T>((*this)[slot]);
        alter(*altered);
        put(slot, std::move(altered), AssetVersion<T>(next_asset_version()));
    }
    // Frees the slot: what comes to it later is of the next generation.
    void release(std::size_t slot) {
        slots_[slot].value.reset();
        ++slots_[slot].generation;
    }

  private:
    struct Slot {
        std::shared_ptr<const T> value;  // null: free
        std::uint32_t generation = 0;
        AssetVersion<T> version;
    };
    std::vector<Slot> slots_;
};

}  // namespace lanthorn
