#include "lanthorn/vertex_map/photon_store.h"

namespace lanthorn::gi {

void PhotonStore::reset(std::size_t total, std::size_t levels) {
    total_ = total;
    levels_ = levels;
    used_ = 0;
    places_.assign(total * levels, {});
    changed_.clear();
    is_changed_.assign(total * levels, false);
}

void PhotonStore::replace(std::size_t photon, std::span<const StoredPhoton> hits) {
    for (std::size_t level = 0; level < levels_; ++level) {
        const std::size_t at = place(photon, level);
        StoredPhoton& kept = places_[at];
        const bool uses = level < hits.size() && hits[level].used;
        if (!uses && !kept.used) {
            continue;
        }
        used_ += uses ? 1 : 0;
        used_ -= kept.used ? 1 : 0;
        kept = uses ? hits[level] : StoredPhoton();
        if (!is_changed_[at]) {
            is_changed_[at] = true;
            changed_.push_back(static_cast<std::uint32_t>(at));
        }
    }
}

void PhotonStore::forget_changed() {
    for (const std::uint32_t at : changed_) {
        is_changed_[at] = false;
    }
    changed_.clear();
}

}  // namespace lanthorn::gi
