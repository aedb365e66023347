// A matrix taken apart into what scene nodes store.
#pragma once

#include "lanthorn/core/math.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// Splits an affine matrix so that matrix = T * R * S * shear (a QR decomposition): R a rotation, S a diagonal
// scale (one axis negative for a mirroring matrix), `shear` upper triangular with ones on its diagonal,
// exactly the identity where the matrix has no shear beyond rounding. A singular matrix has unit scale and
// all its size in `shear`. Elements must be finite.
void decompose(const dmat4& matrix, Transform& transform, mat3& shear);

}  // namespace lanthorn
