#include "gi_module/techniques/vertex-map/photon_store.h"

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
        note_change(at);
    }
}

void PhotonStore::note_change(std::size_t place) {
    if (!is_changed_[place]) {
        is_changed_[place] = true;
        changed_.push_back(static_cast<std::uint32_t>(place));
    }
}

void PhotonStore::carry(const std::unordered_map<SurfaceKey, mat4>& moves) {
    if (moves.empty()) {
        return;
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
        StoredPhoton& photon = places_[i];
        if (!photon.used) {
            continue;
        }
        const auto move = moves.find(photon.surface);
        if (move != moves.end()) {
            photon.position = vec3(move->second * vec4(photon.position, 1));
            // The transposed cofactors turn normals rightly where lengths change.
            const mat3 m(move->second);
            const vec3 normal =
                mat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])) * photon.normal;
            const float length = glm::length(normal);
            photon.normal = length > 0 ? normal / length : photon.normal;
            note_change(i);
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
