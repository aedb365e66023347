// Whether vectors and matrices hold finite numbers only.
#pragma once

#include <cmath>

#include "lanthorn/core/math.h"

namespace lanthorn {

template <glm::length_t N, class T>
bool is_finite(const glm::vec<N, T>& v) {
    for (glm::length_t i = 0; i < N; ++i) {
        if (!std::isfinite(v[i])) {
            return false;
        }
    }
    return true;
}

template <glm::length_t C, glm::length_t R, class T>
bool is_finite(const glm::mat<C, R, T>& m) {
    for (glm::length_t i = 0; i < C; ++i) {
        if (!is_finite(m[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace lanthorn
