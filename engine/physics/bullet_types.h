// Between Bullet's vectors and ours.
#pragma once

#include <LinearMath/btTransform.h>

#include "lanthorn/core/math.h"

namespace lanthorn::physics {

inline btVector3 bt(const dvec3& v) {
    return {v.x, v.y, v.z};
}
inline dvec3 from_bt(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
inline btTransform bt(const dvec3& position, const glm::dquat& rotation) {
    return btTransform(btQuaternion(rotation.x, rotation.y, rotation.z, rotation.w), bt(position));
}
inline glm::dquat rotation_of(const btTransform& t) {
    const btQuaternion q = t.getRotation();
    return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace lanthorn::physics
