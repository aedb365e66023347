#include "engine/deformation/skinning.h"

#include <algorithm>

namespace lanthorn::deform {
namespace {

// Four 3x4 matrices, element by element: of[row * 4 + column].
struct MatrixGroup {
    Lanes of[12];
};

// Four matrices, their rows in lanes, to elements in lanes.
MatrixGroup elements(Lanes (&rows)[3][kLanes]) {
    MatrixGroup m;
    for (int row = 0; row < 3; ++row) {
        auto& r = rows[row];
        transpose(r[0], r[1], r[2], r[3]);
        for (int column = 0; column < 4; ++column) {
            m.of[row * 4 + column] = r[column];
        }
    }
    return m;
}

inline MatrixGroup blended(const SkinStream& skin, const JointMatrix* joints, std::uint32_t group) {
    Lanes rows[3][kLanes] = {};
    const std::uint32_t end = skin.first_round[group + 1];
    for (std::uint32_t round = skin.first_round[group]; round < end; ++round) {
        const Lanes weights = skin.weights[round];
        for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
            const JointMatrix& joint = joints[skin.joints[round].of[lane]];
            const Lanes weight = splat(weights[lane]);
            rows[0][lane] += weight * joint.rows[0];
            rows[1][lane] += weight * joint.rows[1];
            rows[2][lane] += weight * joint.rows[2];
        }
    }
    return elements(rows);
}

// The same in double precision at any scale, for a lane that single precision cannot hold.
vec3 direction_of(const MatrixGroup& m, std::uint32_t lane, const vec3& v, bool as_normal) {
    glm::dmat3 rows;
    double largest = 0;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            rows[r][c] = m.of[r * 4 + c][lane];
            largest = std::max(largest, std::abs(rows[r][c]));
        }
    }
    if (!(largest > 0)) {
        return v;
    }
    rows /= largest;
    dvec3 moved(glm::dot(rows[0], dvec3(v)), glm::dot(rows[1], dvec3(v)), glm::dot(rows[2], dvec3(v)));
    if (as_normal) {
        const glm::dmat3 cofactors(glm::cross(rows[1], rows[2]), glm::cross(rows[2], rows[0]),
                                   glm::cross(rows[0], rows[1]));
        moved = dvec3(glm::dot(cofactors[0], dvec3(v)), glm::dot(cofactors[1], dvec3(v)),
                      glm::dot(cofactors[2], dvec3(v)));
        if (glm::dot(rows[0], cofactors[0]) < 0) {
            moved = -moved;
        }
    }
    return unit_or(moved, v);
}

inline void transform(const MatrixGroup& m, const VertexGroup& from, VertexGroup& to) {
    using Bits = std::int32_t __attribute__((vector_size(16)));
    const Lanes* const x = m.of;
    const Lanes* const y = m.of + 4;
    const Lanes* const z = m.of + 8;
    const auto& p = from.position;
    const auto& n = from.normal;
    const auto& t = from.tangent;
    to.position = {x[0] * p[0] + x[1] * p[1] + x[2] * p[2] + x[3],
                   y[0] * p[0] + y[1] * p[1] + y[2] * p[2] + y[3],
                   z[0] * p[0] + z[1] * p[1] + z[2] * p[2] + z[3]};
    to.tangent = {x[0] * t[0] + x[1] * t[1] + x[2] * t[2], y[0] * t[0] + y[1] * t[1] + y[2] * t[2],
                  z[0] * t[0] + z[1] * t[1] + z[2] * t[2]};
    // Cofactors are the inverse transpose times the determinant, whose sign must not turn the normal.
    const Lanes xx = y[1] * z[2] - y[2] * z[1], xy = y[2] * z[0] - y[0] * z[2],
                xz = y[0] * z[1] - y[1] * z[0];
    const Lanes yx = z[1] * x[2] - z[2] * x[1], yy = z[2] * x[0] - z[0] * x[2],
                yz = z[0] * x[1] - z[1] * x[0];
    const Lanes zx = x[1] * y[2] - x[2] * y[1], zy = x[2] * y[0] - x[0] * y[2],
                zz = x[0] * y[1] - x[1] * y[0];
    const Lanes determinant = x[0] * xx + x[1] * xy + x[2] * xz;
    const Bits turn = determinant < splat(0) ? Bits{} + INT32_MIN : Bits{};
    const auto turned = [turn](Lanes v) { return reinterpret_cast<Lanes>(reinterpret_cast<Bits>(v) ^ turn); };
    to.normal = {turned(xx * n[0] + xy * n[1] + xz * n[2]), turned(yx * n[0] + yy * n[1] + yz * n[2]),
                 turned(zx * n[0] + zy * n[1] + zz * n[2])};
    to.sign = turned(from.sign);
    normalise(to.normal, [&](std::uint32_t lane) { return direction_of(m, lane, lane_of(n, lane), true); });
    normalise(to.tangent, [&](std::uint32_t lane) { return direction_of(m, lane, lane_of(t, lane), false); });
}

// Writes those of the group's vertices that exist.
inline void finish(VertexGroup& group, const BindPose& pose, std::uint32_t index, VertexFrame* to,
                   BoundsLanes& bounds) {
    const std::uint32_t count = std::min(kLanes, pose.vertex_count - index * kLanes);
    for (std::uint32_t lane = count; lane < kLanes; ++lane) {
        set_lane(group.position, lane, lane_of(group.position, 0));
    }
    bounds.add(group.position);
    write(group, count, to);
}

}  // namespace

JointMatrix joint_matrix(const dmat4& joint, const mat4& inverse_bind, const dvec3& at) {
    const dmat4 bind(inverse_bind);
    const dvec3 origin = dvec3(joint[3]) - at;
    JointMatrix m;
    for (int row = 0; row < 3; ++row) {
        const dvec3 r(joint[0][row], joint[1][row], joint[2][row]);
        for (int column = 0; column < 4; ++column) {
            const double own = r.x * bind[column].x + r.y * bind[column].y + r.z * bind[column].z;
            m.rows[row][column] = static_cast<float>(column == 3 ? own + origin[row] : own);
        }
    }
    return m;
}

mat4 matrix(const JointMatrix& m) {
    mat4 result(1);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            result[column][row] = m.rows[row][column];
        }
    }
    return result;
}

bool finite(const JointMatrix& m) {
    // 0 times what is not finite is not 0.
    const Lanes zero = (m.rows[0] + m.rows[1] + m.rows[2]) * 0.0f;
    return zero[0] + zero[1] + zero[2] + zero[3] == 0;
}

bool mirrors(const JointMatrix& m) {
    const auto row = [&](int i) { return dvec3(m.rows[i][0], m.rows[i][1], m.rows[i][2]); };
    return glm::dot(row(0), glm::cross(row(1), row(2))) < 0;
}

void skin_groups(const BindPose& pose, std::span<const JointMatrix> joints, std::uint32_t first_group,
                 std::span<const VertexGroup> groups, VertexFrame* to, BoundsLanes& bounds) {
    VertexGroup moved;
    for (std::uint32_t g = 0; g < groups.size(); ++g, to += kLanes) {
        transform(blended(pose.skin, joints.data(), first_group + g), groups[g], moved);
        finish(moved, pose, first_group + g, to, bounds);
    }
}

void move_groups(const BindPose& pose, const JointMatrix& matrix, std::uint32_t first_group,
                 std::span<const VertexGroup> groups, VertexFrame* to, BoundsLanes& bounds) {
    MatrixGroup all;
    for (int i = 0; i < 12; ++i) {
        all.of[i] = splat(matrix.rows[i / 4][i % 4]);
    }
    VertexGroup moved;
    for (std::uint32_t g = 0; g < groups.size(); ++g, to += kLanes) {
        transform(all, groups[g], moved);
        finish(moved, pose, first_group + g, to, bounds);
    }
}

void copy_groups(const BindPose& pose, std::uint32_t first_group, std::span<const VertexGroup> groups,
                 VertexFrame* to, BoundsLanes& bounds) {
    for (std::uint32_t g = 0; g < groups.size(); ++g, to += kLanes) {
        VertexGroup group = groups[g];
        finish(group, pose, first_group + g, to, bounds);
    }
}

}  // namespace lanthorn::deform
