// Rays of a TraceScene: what they meet, and what they pass.
#include <algorithm>
#include <limits>

#include "engine/scene/alpha_coverage.h"
#include "gi_module/reference/material_table.h"
#include "gi_module/reference/ray_log.h"
#include "gi_module/reference/trace_filter.h"

namespace lanthorn::reference {

namespace {

// A shadow ray to a light ends this share short of it: what touches the light does not hide it.
constexpr float kShadowEnd = 1.0f - 1e-5f;

}  // namespace

// Of a masked material where it is cut out, of a blended one where it is not met, of a reduced shape where it
// is nearer than it is exact.
void TraceScene::pass_left_out(const RTCFilterFunctionNArguments* arguments) {
    const auto& data = *static_cast<const FilterData*>(arguments->geometryUserPtr);
    if (data.nearest > 0) {
        const vec3 direction(RTCRayN_dir_x(arguments->ray, arguments->N, 0),
                             RTCRayN_dir_y(arguments->ray, arguments->N, 0),
                             RTCRayN_dir_z(arguments->ray, arguments->N, 0));
        if (RTCRayN_tfar(arguments->ray, arguments->N, 0) * glm::length(direction) < data.nearest) {
            *arguments->valid = 0;
            return;
        }
    }
    const std::uint32_t primitive = RTCHitN_primID(arguments->hit, arguments->N, 0);
    const vec2 barycentric(RTCHitN_u(arguments->hit, arguments->N, 0),
                           RTCHitN_v(arguments->hit, arguments->N, 0));
    if (data.mask && data.materials->cut_out(data.scene->instances_[data.instance], primitive, barycentric)) {
        *arguments->valid = 0;
    }
    const auto blended = static_cast<Blended>(RTCRayN_mask(arguments->ray, arguments->N, 0));
    if (data.blend && blended != Blended::met) {
        const float alpha =
            data.materials->alpha(data.scene->instances_[data.instance], primitive, barycentric);
        const float t = RTCRayN_tfar(arguments->ray, arguments->N, 0);
        const vec3 p(RTCRayN_org_x(arguments->ray, arguments->N, 0) +
                         t * RTCRayN_dir_x(arguments->ray, arguments->N, 0),
                     RTCRayN_org_y(arguments->ray, arguments->N, 0) +
                         t * RTCRayN_dir_y(arguments->ray, arguments->N, 0),
                     RTCRayN_org_z(arguments->ray, arguments->N, 0) +
                         t * RTCRayN_dir_z(arguments->ray, arguments->N, 0));
        if (blended == Blended::solid ? alpha < kSolidAlpha : alpha <= alpha_threshold(p)) {
            *arguments->valid = 0;
        }
    }
}

void TraceScene::pass_backs(const RTCFilterFunctionNArguments* arguments) {
    const auto& data = *static_cast<const FilterData*>(arguments->geometryUserPtr);
    const TraceInstance& instance = data.scene->instances_[data.instance];
    const std::uint32_t primitive = RTCHitN_primID(arguments->hit, arguments->N, 0);
    const vec3 direction(RTCRayN_dir_x(arguments->ray, arguments->N, 0),
                         RTCRayN_dir_y(arguments->ray, arguments->N, 0),
                         RTCRayN_dir_z(arguments->ray, arguments->N, 0));
    const bool back =
        !(glm::dot(data.scene->triangles_[instance.first_triangle + primitive].normal, direction) < 0);
    if (back && !(*data.materials)[instance.material].double_sided) {
        *arguments->valid = 0;
    }
}

void TraceScene::prefer_front(const vec3& origin, const vec3& direction, Blended blended,
                              SurfaceHit& hit) const {
    if (hit.front) {
        return;
    }
    const float tolerance =
        triangles_[hit.triangle].offset / std::max(glm::length(direction), 1e-30f) + 1e-6f * hit.t;
    SurfaceHit other;
    if (intersect(origin, direction, std::max(hit.t - tolerance, 0.0f), hit.t + tolerance, blended, other,
                  Sides::seen)) {
        hit = other;
    }
}

void TraceScene::intersect_all(std::span<RTCRayHit> queries) const {
    if (log_ != nullptr) {
        for (const RTCRayHit& query : queries) {
            log_->rays.push_back({query.ray, false});
        }
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (RTCRayHit& query : queries) {
        rtcIntersect1(scene_, &context, &query);
    }
}

bool TraceScene::intersect(const vec3& origin, const vec3& direction, float nearest, float farthest,
                           Blended blended, SurfaceHit& hit, Sides sides) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (sides == Sides::seen) {
        context.filter = pass_backs;
    }
    RTCRayHit ray = query(origin, direction, nearest, farthest, blended);
    if (log_ != nullptr) {
        log_->rays.push_back({ray.ray, false});
    }
    rtcIntersect1(scene_, &context, &ray);
    return found(ray, hit);
}

RTCRay TraceScene::shadow_ray(const vec3& from, const vec3& span, bool to_infinity, Blended blended) {
    return {from.x,
            from.y,
            from.z,
            0,
            span.x,
            span.y,
            span.z,
            0,
            to_infinity ? std::numeric_limits<float>::infinity() : kShadowEnd,
            static_cast<unsigned>(blended),
            0,
            0};
}

void TraceScene::occlude_all(std::span<RTCRay> rays) const {
    if (log_ != nullptr) {
        for (const RTCRay& ray : rays) {
            log_->rays.push_back({ray, true});
        }
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (RTCRay& ray : rays) {
        rtcOccluded1(scene_, &context, &ray);
    }
}

bool TraceScene::occluded(const vec3& from, const vec3& span, bool to_infinity, Blended blended) const {
    RTCRay ray = shadow_ray(from, span, to_infinity, blended);
    occlude_all(std::span(&ray, 1));
    return is_occluded(ray);
}

}  // namespace lanthorn::reference
