#include "engine/deformation/limit_stencils.h"

namespace lanthorn::deform {
namespace {

// Any unit vector across `normal`.
vec3 across(const vec3& normal) {
    const vec3 axis = std::abs(normal.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0);
    return glm::normalize(glm::cross(axis, normal));
}

// Position, du and dv of one vertex.
inline void add_up(const LimitStencils& stencils, const LimitVertex& vertex, const Lanes* controls,
                   Lanes& position, Lanes& du, Lanes& dv) {
    position = du = dv = Lanes{};
    const StencilEntry* const end = stencils.entries.data() + vertex.end;
    for (const StencilEntry* entry = stencils.entries.data() + vertex.first; entry != end; ++entry) {
        const Lanes control = controls[entry->control];
        position += splat(entry->position) * control;
        du += splat(entry->du) * control;
        dv += splat(entry->dv) * control;
    }
}

}  // namespace

void evaluate(const LimitStencils& stencils, std::span<const Lanes> controls, bool mirrored,
              std::uint32_t first, std::uint32_t end, VertexFrame* to, BoundsLanes& bounds) {
    const Lanes turn = splat(mirrored ? -1.0f : 1.0f);
    for (std::uint32_t i = first; i < end; i += kLanes) {
        const std::uint32_t count = std::min(kLanes, end - i);
        Lanes p[kLanes], u[kLanes], v[kLanes];
        Lanes along_du{}, along_dv{};
        VertexGroup group;
        for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
            const LimitVertex& vertex = stencils.vertices[i + std::min(lane, count - 1)];
            add_up(stencils, vertex, controls.data(), p[lane], u[lane], v[lane]);
            along_du[lane] = vertex.along_du;
            along_dv[lane] = vertex.along_dv;
            group.sign[lane] = vertex.sign;
        }
        transpose(p[0], p[1], p[2], p[3]);
        transpose(u[0], u[1], u[2], u[3]);
        transpose(v[0], v[1], v[2], v[3]);
        group.position = {p[0], p[1], p[2]};
        group.normal = {turn * (u[1] * v[2] - u[2] * v[1]), turn * (u[2] * v[0] - u[0] * v[2]),
                        turn * (u[0] * v[1] - u[1] * v[0])};
        group.tangent = {along_du * u[0] + along_dv * v[0], along_du * u[1] + along_dv * v[1],
                         along_du * u[2] + along_dv * v[2]};
        group.sign *= turn;
        normalise(group.normal, [&](std::uint32_t lane) {
            const dvec3 a(u[0][lane], u[1][lane], u[2][lane]), b(v[0][lane], v[1][lane], v[2][lane]);
            return unit_or(double(turn[0]) * glm::cross(a, b),
                           stencils.vertices[i + std::min(lane, count - 1)].normal);
        });
        const auto tangent = group.tangent;
        normalise(group.tangent, [&](std::uint32_t lane) {
            return unit_or(dvec3(lane_of(tangent, lane)), across(lane_of(group.normal, lane)));
        });
        bounds.add(group.position);
        write(group, count, to + i);
    }
}

}  // namespace lanthorn::deform
