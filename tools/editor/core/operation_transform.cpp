// move, rotate, scale.
#include <fmt/format.h>

#include <glm/gtc/quaternion.hpp>

#include "lanthorn/scene/transforms.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::editor {

namespace {

std::string array_of(const dvec3& v) {
    return fmt::format("[{},{},{}]", number(v.x), number(v.y), number(v.z));
}

std::string array_of(const quat& q) {
    return fmt::format("[{},{},{},{}]", number(q.x), number(q.y), number(q.z), number(q.w));
}

quat turned(Operation& op) {
    op.expect_count({4, 5});
    if (op.count() == 4) {
        const dvec3 degrees = op.vector_at(2);
        const dvec3 angle = glm::radians(degrees);
        return quat(glm::angleAxis(angle.z, dvec3(0, 0, 1)) * glm::angleAxis(angle.y, dvec3(0, 1, 0)) *
                    glm::angleAxis(angle.x, dvec3(1, 0, 0)));
    }
    const glm::dquat q(op.number_at(5), op.number_at(2), op.number_at(3), op.number_at(4));
    const double length = glm::length(q);
    if (!(length > 1e-6)) {
        op.refuse("found a quaternion of length 0, expected length 1");
    }
    return quat(q / length);
}

}  // namespace

void apply_transform(Operation& op) {
    const std::uint32_t node = op.node_at_word(1);
    const std::string path = path_of(op.model, node);
    const ModelNode before = op.model.node(node);
    Transform local = before.local;
    op.result.path = path;
    op.result.touched = {node};
    if (op.name() == "move") {
        op.expect_count({4});
        local.translation = op.vector_at(2);
        op.set_local(node, local, before.shear);
        const dvec3 now = op.model.node(node).local.translation;
        op.say({word(path), number(local.translation.x), number(local.translation.y),
                number(local.translation.z)});
        op.result.before = array_of(before.local.translation);
        op.result.after = array_of(now);
        return;
    }
    if (op.name() == "rotate") {
        local.rotation = turned(op);
        op.set_local(node, local, before.shear);
        const quat now = op.model.node(node).local.rotation;
        op.say({word(path), number(now.x), number(now.y), number(now.z), number(now.w)});
        op.result.before = array_of(before.local.rotation);
        op.result.after = array_of(now);
        return;
    }
    op.expect_count({2, 4});
    const dvec3 size = op.count() == 2 ? dvec3(op.number_at(2)) : op.vector_at(2);
    if (size.x == 0 || size.y == 0 || size.z == 0) {
        op.refuse("found 0, expected a size that leaves something to see");
    }
    local.scale = vec3(size);
    op.set_local(node, local, before.shear);
    op.say({word(path), number(local.scale.x), number(local.scale.y), number(local.scale.z)});
    op.result.before = array_of(dvec3(before.local.scale));
    op.result.after = array_of(dvec3(local.scale));
}

}  // namespace lanthorn::editor
