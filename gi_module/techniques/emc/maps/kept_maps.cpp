#include "gi_module/techniques/emc/maps/kept_maps.h"

#include <algorithm>
#include <utility>

namespace lanthorn::gi {

const KeptMap* KeptMaps::find(const vec3& centre) {
    const auto map = std::ranges::find(maps_, centre, &KeptMap::centre);
    if (map == maps_.end()) {
        return nullptr;
    }
    maps_.splice(maps_.begin(), maps_, map);
    return &maps_.front();
}

void KeptMaps::keep(KeptMap map, std::size_t budget) {
    std::erase_if(maps_, [&](const KeptMap& other) { return other.centre == map.centre; });
    maps_.push_front(std::move(map));
    while (!maps_.empty() && bytes() > budget) {
        maps_.pop_back();
    }
}

void KeptMaps::drop_if(const std::function<bool(const KeptMap&)>& outdated) {
    std::erase_if(maps_, outdated);
}

std::size_t KeptMaps::bytes() const {
    std::size_t sum = 0;
    for (const KeptMap& map : maps_) {
        sum += map.bytes();
    }
    return sum;
}

}  // namespace lanthorn::gi
