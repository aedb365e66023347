#include "engine/assets/gltf_uv_sets.h"

namespace lanthorn {

UvSets choose_uv_sets(const std::set<std::uint32_t>& used) {
    UvSets result = kPlainUvSets;
    std::array<bool, 2> taken{used.contains(0), used.contains(1)};
    for (const std::uint32_t set : used) {
        for (std::size_t place = 0; place < 2 && set > 1; ++place) {
            if (!taken[place]) {
                taken[place] = true;
                result[place] = set;
                break;
            }
        }
    }
    return result;
}

}  // namespace lanthorn
