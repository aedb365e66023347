#include "engine/deformation/sparse_rows.h"

#include <algorithm>

namespace lanthorn::deform {

void SparseRows::end_row() {
    std::sort(touched_.begin(), touched_.end());
    for (const std::uint32_t index : touched_) {
        if (at_[index] != 0) {
            terms_.push_back({index, static_cast<float>(at_[index])});
        }
        at_[index] = 0;
        used_[index] = 0;
    }
    touched_.clear();
    ends_.push_back(terms_.size());
}

}  // namespace lanthorn::deform
